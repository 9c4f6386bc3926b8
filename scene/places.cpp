#include "scene/places.h"

#include <fmt/format.h>

#include "scene/document.h"
#include "scene/error.h"
#include "scene/input.h"

namespace brandung {
namespace {

std::string place_in_file(const Scene &scene, const std::string &pointer) try {
    return place_of({.file = scene.file, .text = file_text(scene.file), .root = {}, .assigned = {}, .progress = {}}, pointer);
} catch (const SceneError &) {
    return "";
}

}  // namespace

std::string object_pointer(std::optional<std::size_t> group, std::size_t object) {
    return (group ? fmt::format("/groups/{}", *group) : "") + fmt::format("/objects/{}", object);
}

std::string place_of_material(const Scene &scene, uint material) {
    const std::string &place = scene.materials.at(material).place;
    return place.empty() ? place_in_file(scene, fmt::format("/materials/{}", material)) : place;
}

std::string place_of_shape(const Scene &scene, std::optional<std::size_t> group, const Shape &shape) {
    return shape.object == NO_OBJECT ? place_of_material(scene, shape.material) : place_in_file(scene, object_pointer(group, shape.object));
}

}  // namespace brandung
