#include "scene/materials_in_use.h"

namespace brandung {

std::vector<bool> materials_in_use(const Scene &scene) {
    std::vector<bool> used(scene.materials.size()), shows_its_own(scene.groups.size());
    const auto add = [&](const std::vector<std::unique_ptr<Shape>> &shapes) {
        for (const auto &shape : shapes) used.at(shape->material) = true;
    };
    add(scene.shapes);
    for (const PlacedGroup &instance : scene.instances) {
        if (instance.material == NO_MATERIAL)
            shows_its_own[instance.group] = true;
        else
            used.at(instance.material) = true;
    }
    for (std::size_t g = 0; g < scene.groups.size(); ++g)
        if (shows_its_own[g]) add(scene.groups[g].shapes);
    return used;
}

}  // namespace brandung
