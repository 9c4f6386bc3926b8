#include "tests/support/random_scenes/random_scene.h"

#include <array>

#include "scene/samplers/sampler.h"

namespace brandung {
namespace {

using Json = nlohmann::ordered_json;

/// From 0 to 1, often at the ends.
Json fraction(Dice &dice) {
    const uint kind = dice.below(10);
    if (kind < 3) return 0;
    if (kind < 5) return 1;
    if (kind < 8) return dice.uniform(0, 1);
    return {dice.uniform(0, 1), dice.uniform(0, 1), dice.uniform(0, 1)};
}

Json colour(Dice &dice, double scale) {
    if (dice.chance(50)) return scale * dice.uniform(0, 1);
    return {scale * dice.uniform(0, 1), scale * dice.uniform(0, 1), 0};
}

Json reflectance(Dice &dice) {
    if (dice.chance(12)) return {{"texture", "tiles.png"}, {"wrap", dice.pick({"repeat", "clamp"})}, {"scale", dice.uniform(0, 2)}};
    return colour(dice, dice.chance(10) ? 2 : 1);
}

Json film(Dice &dice) {
    const uint width = dice.chance(10) ? 1 : 16, height = dice.chance(10) ? 1 : 12;
    Json film = {{"width", width}, {"height", height}, {"spp", 1 + dice.below(3)}, {"seed", dice.below(1000)}};
    if (dice.chance(20)) film["pixel"] = "random";
    if (dice.chance(30)) film["filter"] = dice.pick({"tent", "gaussian", "mitchell", "blackman_harris"});
    if (dice.chance(5)) film["spp"] = 1, film["pixel"] = "corner", film.erase("filter");
    if (dice.chance(10)) film["crop"] = {0, 0, 1 + dice.below(width), 1 + dice.below(height)};
    return film;
}

Json integrator(Dice &dice) {
    return {{"max_depth", 1 + dice.below(5)},
            {"threshold", dice.pick({0.0, 0.0, 0.03})},
            {"light_samples", dice.pick({0, 1, 1, 2, 3})},
            {"shadows", dice.pick({"opaque", "filtered"})}};
}

/// From outside, or from among the things; inside of some that are transparent.
Json camera(Dice &dice, const RandomSpace &space, const Json &materials) {
    const Json from = random_point(dice, space, dice.pick({0.8, 3.0, 3.0, 30.0}));
    Json camera = {{"from", from}, {"at", random_point(dice, space)}, {"up", random_direction(dice)}};
    camera["fov"] = dice.pick({0.01, 20.0, 45.0, 45.0, 90.0, 170.0});
    camera["inside"] = Json::array();
    for (const Json &material : materials)
        if (material["transmission"] != 0 && dice.chance(10)) camera["inside"].push_back(material["name"]);
    return camera;
}

Json background(Dice &dice) {
    if (dice.chance(10)) return {{"image", "sky.png"}, {"rotate", dice.uniform(-360, 360)}, {"scale", dice.uniform(0, 2)}};
    return colour(dice, 1);
}

/// By dice of their own, so that the rest of a seed's scene stays what it was before these settings were drawn.
void draw_paths(std::uint64_t seed, Json &scene) {
    Dice dice(~seed);
    if (const uint sampler = dice.below(static_cast<uint>(sampler_kinds().size())); sampler > 0)
        scene["film"]["sampler"] = sampler_kinds()[sampler].name;
    if (dice.chance(40)) scene["integrator"]["follow"] = "one";
}

/// In floats, one thing after another must not leave the numbers that a file may have.
RandomSpace space(Dice &dice) {
    RandomSpace space;
    if (dice.chance(35)) space.unit = dice.power(-20, 20);
    if (dice.chance(15))
        for (double &x : space.offset) {
            const double far = space.unit * dice.power(0, 14);
            x = far * dice.pick({-1, 0, 1});
        }
    return space;
}

}  // namespace

nlohmann::ordered_json random_material(Dice &dice, uint number) {
    const bool transparent = dice.chance(35), shines = dice.chance(15);
    Json material = {{"type", "whitted"}, {"name", std::to_string(number)}, {"diffuse", reflectance(dice)}};
    if (dice.chance(20)) material["ambient"] = colour(dice, 1);
    if (dice.chance(40)) material["specular"] = reflectance(dice), material["exponent"] = dice.pick({1.0, 10.0, 300.0, 0.001, 1e6});
    material["reflection"] = dice.chance(40) ? fraction(dice) : Json(0);
    material["transmission"] = transparent ? fraction(dice) : Json(0);
    material["eta"] = dice.pick({1.5, 1.5, 1.33, 1.0, 0.6, 2.4, 0.01, 100.0});
    material["fresnel"] = dice.chance(60);
    material["priority"] = dice.below(3);
    if (shines) {
        material["emission"] = colour(dice, 3);
        Dice aside = dice;  // so that the numbers of what follows stay those that they were
        const char *sides[] = {"both", "both", "front", "back"};
        material["emission_side"] = sides[aside.below(4)];
    }
    return material;
}

nlohmann::ordered_json random_light(Dice &dice, const RandomSpace &space) {
    const double unit = space.unit;
    const Json place = random_point(dice, space, dice.pick({1.0, 3.0, 100.0})), way = random_direction(dice);
    if (dice.chance(25)) return {{"type", "directional"}, {"direction", way}, {"irradiance", colour(dice, 3)}};
    Dice again = dice;
    Json light = {{"type", "point"}, {"position", place}, {"intensity", colour(dice, 30 * unit * unit)}};
    if (dice.chance(50)) {
        light["type"] = "spot", light["direction"] = way;
        light["angle"] = dice.pick({0.1, 40.0, 60.0, 180.0, 300.0, 360.0});
        light["penumbra"] = dice.pick({0.0, 0.2, 1.0});
    }
    if (dice.chance(30)) {
        light["intensity"] = colour(again, 30 * unit);
        const auto [constant, linear, quadratic] = dice.pick<std::array<double, 3>>({{1, 0, 0}, {0, 1, 0}, {1, 0.5, 0.25}, {0, 0, 1}});
        light["attenuation"] = {constant * unit, linear, quadratic / unit};
    }
    return light;
}

nlohmann::ordered_json random_scene(std::uint64_t seed, double scale) {
    Dice dice(seed);
    RandomSpace where = space(dice);
    where.unit *= scale;
    for (double &x : where.offset) x *= scale;
    Json scene = {{"film", film(dice)}, {"integrator", integrator(dice)}, {"background", background(dice)}, {"ambient", colour(dice, 0.3)}};
    draw_paths(seed, scene);
    const uint materials = 1 + dice.below(5);
    for (uint i = 0; i < materials; ++i) scene["materials"].push_back(random_material(dice, i));
    scene["camera"] = camera(dice, where, scene["materials"]);
    for (uint count = dice.chance(5) ? 17 : dice.below(5); count > 0; --count) scene["lights"].push_back(random_light(dice, where));
    const uint groups = dice.chance(40) ? 1 + dice.below(2) : 0;
    for (uint g = 0; g < groups; ++g) {
        Json group = {{"name", std::to_string(g)}, {"objects", Json::array()}};
        for (uint count = dice.below(6); count > 0; --count) group["objects"].push_back(random_object(dice, where, materials));
        scene["groups"].push_back(group);
    }
    scene["objects"] = Json::array();
    for (uint count = dice.chance(10) ? 40 : dice.below(12); count > 0; --count) {
        if (groups > 0 && dice.chance(30)) {
            Json instance = {{"type", "instance"}, {"group", std::to_string(dice.below(groups))}, {"transform", random_transform(dice, where)}};
            if (dice.chance(30)) instance["material"] = std::to_string(dice.below(materials));
            scene["objects"].push_back(instance);
        } else if (!scene["objects"].empty() && dice.chance(5)) {
            scene["objects"].push_back(scene["objects"].back());  // everything twice, at the same place
        } else {
            scene["objects"].push_back(random_object(dice, where, materials));
        }
    }
    return scene;
}

}  // namespace brandung
