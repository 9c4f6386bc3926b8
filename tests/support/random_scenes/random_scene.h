/// Scenes at random: every kind of object, material, light, filter and sampler, either way to follow rays, at odd scales, with parts that are
/// degenerate, coincide or contain each other.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>

#include "tests/support/random_scenes/dice.h"

namespace brandung {

/// A scene file in the native format; the same for a seed everywhere. It names the pictures "tiles.png" and "sky.png" and the mesh "vase.obj" beside
/// it.
/// All lengths but those of that mesh are `scale` times as large, and lights so much brighter that the picture is the same.
nlohmann::ordered_json random_scene(std::uint64_t seed, double scale = 1);

/// Where things are: about the origin, or far from it, in any unit of length.
struct RandomSpace {
    double unit = 1;
    double offset[3] = {0, 0, 0};
};

/// Points of it, objects and steps of transforms. `materials` are so many, "0", "1", ...
nlohmann::ordered_json random_point(Dice &dice, const RandomSpace &space, double reach = 1);
nlohmann::ordered_json random_direction(Dice &dice);
nlohmann::ordered_json random_object(Dice &dice, const RandomSpace &space, uint materials);
nlohmann::ordered_json random_transform(Dice &dice, const RandomSpace &space);
nlohmann::ordered_json random_material(Dice &dice, uint number);
nlohmann::ordered_json random_light(Dice &dice, const RandomSpace &space);

}  // namespace brandung
