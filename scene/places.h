/// Places of a scene's things in the files that it was read from, for what is said of them afterwards.
#pragma once
#include <optional>
#include <string>

#include "scene/scene.h"

namespace brandung {

/// Of an object of a native scene file, or of one of its groups.
std::string object_pointer(std::optional<std::size_t> group, std::size_t object);

/// `file:line`, with the JSON pointer where a native scene file says it, which is looked into again; empty where that is not possible any more.
std::string place_of_material(const Scene &scene, uint material);
/// Of the object that the shape belongs to, or of its material where objects have no numbers.
std::string place_of_shape(const Scene &scene, std::optional<std::size_t> group, const Shape &shape);

}  // namespace brandung
