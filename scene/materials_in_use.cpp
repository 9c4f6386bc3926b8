#include "scene/materials_in_use.h"

#include "scene/bsdfs/choosing.h"

namespace brandung {
namespace {

void use(const Scene &scene, uint material, std::vector<bool> &used) {
    used.at(material) = true;
    for (const uint member : members_of(scene.materials[material].record)) use(scene, member, used);
}

}  // namespace

std::vector<bool> materials_in_use(const Scene &scene) {
    std::vector<bool> used(scene.materials.size()), shows_its_own(scene.groups.size());
    const auto add = [&](const std::vector<std::unique_ptr<Shape>> &shapes) {
        for (const auto &shape : shapes) use(scene, shape->material, used);
    };
    add(scene.shapes);
    for (const PlacedGroup &instance : scene.instances) {
        if (instance.material == NO_MATERIAL)
            shows_its_own[instance.group] = true;
        else
            use(scene, instance.material, used);
    }
    for (std::size_t g = 0; g < scene.groups.size(); ++g)
        if (shows_its_own[g]) add(scene.groups[g].shapes);
    return used;
}

}  // namespace brandung
