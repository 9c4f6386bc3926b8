#include "scene/compilation/spaces.h"

#include <algorithm>
#include <set>

#include "scene/bsdfs/choosing.h"

namespace brandung {
namespace {

Space space_of(const Shapes &shapes, std::size_t first) {
    Space space{{}, static_cast<uint>(first)};
    std::size_t count = 0;
    for (const auto &shape : shapes) count += shape->count();
    space.primitives.reserve(count);
    for (const auto &shape : shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) space.primitives.push_back({shape.get(), i});
    return space;
}

}  // namespace

std::vector<std::size_t> groups_in_use(const Scene &scene) {
    std::set<std::size_t> used;
    for (const PlacedGroup &instance : scene.instances) used.insert(instance.group);
    return {used.begin(), used.end()};
}

std::vector<const Shapes *> shapes_in_use(const Scene &scene) {
    std::vector<const Shapes *> result = {&scene.shapes};
    for (const std::size_t group : groups_in_use(scene)) result.push_back(&scene.groups[group].shapes);
    return result;
}

std::size_t place_in(const std::vector<std::size_t> &used, std::size_t group) {
    return static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), group) - used.begin());
}

bool is_textured(const Scene &scene, uint material) {
    const Material &record = scene.materials.at(material).record;
    const std::vector<uint> members = members_of(record);
    return record.diffuse_texture != 0 || record.specular_texture != 0 ||
           std::any_of(members.begin(), members.end(), [&](uint member) { return is_textured(scene, member); });
}

std::vector<Space> spaces_in_use(const Scene &scene) {
    std::vector<Space> spaces;
    std::size_t count = 0;
    for (const Shapes *shapes : shapes_in_use(scene)) {
        spaces.push_back(space_of(*shapes, count));
        count += spaces.back().primitives.size();
    }
    const std::vector<std::size_t> used = groups_in_use(scene);
    for (const PlacedGroup &instance : scene.instances) {
        if (instance.material == NO_MATERIAL || !is_textured(scene, instance.material)) continue;
        spaces[1 + place_in(used, instance.group)].is_textured = true;
    }
    return spaces;
}

std::vector<const PrimitiveKind *> primitive_kinds_in_use(const Scene &scene) {
    std::set<const PrimitiveKind *> used;
    for (const Shapes *shapes : shapes_in_use(scene))
        for (const auto &shape : *shapes)
            if (shape->count() > 0) used.insert(&shape->kind());
    std::vector<const PrimitiveKind *> kinds;
    for (const PrimitiveKind *kind : primitive_kinds())
        if (used.contains(kind)) kinds.push_back(kind);
    return kinds;
}

}  // namespace brandung
