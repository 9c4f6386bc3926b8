#include "tools/scene_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string_view>

#include "kernels/primitives/instance.h"
#include "scene/compilation/spaces.h"
#include "scene/lights/light.h"
#include "scene/places.h"

namespace brandung {

using nlohmann::json;

SceneObjects::SceneObjects(const Scene &scene) : scene_(scene), lights_(make_light_rows(scene)) {
    uint first = 0;
    add_shapes(scene.shapes, {}, first);
    for (const std::size_t group : groups_in_use(scene)) add_shapes(scene.groups[group].shapes, static_cast<uint>(group), first);
}

void SceneObjects::add_shapes(const std::vector<std::unique_ptr<Shape>> &shapes, std::optional<uint> group, uint &first) {
    uint number = 0;
    for (const auto &shape : shapes) {
        place_of_shape_.emplace(shape.get(), shapes_.size());
        shapes_.push_back({first, shape.get(), group, number++});
        first += static_cast<uint>(shape->count());
    }
}

std::string SceneObjects::place_in_file(const std::string &pointer) {
    if (!document_) document_ = read_document(scene_.file);
    const auto [place, is_new] = places_.try_emplace(pointer);
    if (is_new) place->second = place_of(*document_, pointer);
    return place->second;
}

json SceneObjects::place(std::optional<uint> group, uint object) {
    if (object == NO_OBJECT) return nullptr;
    return place_in_file(object_pointer(group, object));
}

/// Of files of meshes and NFF; null for what a native scene file says itself.
json SceneObjects::source(const Shape &shape, uint primitive) const {
    if (!scene_.places) return nullptr;
    const auto known = scene_.places->find(&shape);
    return known == scene_.places->end() ? json(nullptr) : json(fmt::format("{}{}", known->second.before, known->second.numbers.at(primitive)));
}

json SceneObjects::shape(const Placed &placed) {
    const Shape &shape = *placed.shape;
    return {{"kind", shape.kind().name},
            {"shape", placed.number},
            {"material", scene_.materials[shape.material].name},
            {"group", placed.group ? json(scene_.groups[*placed.group].name) : json(nullptr)},
            {"object", shape.object == NO_OBJECT ? json(nullptr) : json(shape.object)},
            {"place", place(placed.group, shape.object)}};
}

json SceneObjects::instance(uint number) {
    if (number == 0) return nullptr;
    const PlacedGroup &placed = scene_.instances[number - 1];
    return {
        {"number", number - 1}, {"object", placed.object == NO_OBJECT ? json(nullptr) : json(placed.object)}, {"place", place({}, placed.object)}};
}

json SceneObjects::primitive(uint number, uint instance_number) {
    const auto next = std::upper_bound(shapes_.begin(), shapes_.end(), number, [](uint n, const Placed &placed) { return n < placed.first; });
    const Placed &placed = *std::prev(next);
    json result = shape(placed);
    result["primitive"] = number;
    result["primitive_of_shape"] = number - placed.first;
    result["source"] = source(*placed.shape, number - placed.first);
    result["instance"] = instance(instance_number);
    const uint material = instance_number == 0 ? NO_MATERIAL : scene_.instances[instance_number - 1].material;
    if (material != NO_MATERIAL) result["material"] = scene_.materials[material].name;
    return result;
}

/// A cell of a grid, or of those of a mesh, which lie along a curve, or for paths a face; those of a shape follow each other.
json SceneObjects::stratum(uint row) const {
    Emission emission;
    std::memcpy(&emission, lights_.rows[row].words, sizeof emission);
    const bool flat = std::string_view(light_kinds()[lights_.rows[row].kind].name) == "emissive_flat";
    const uint cell = flat ? 0 : emission.stratum.cell;
    if (cell == 0) {
        const auto is_another = [&](const PlacedShape &placed) {
            return placed.shape != lights_.shapes[row].shape || placed.instance != lights_.shapes[row].instance;
        };
        const auto begin = lights_.shapes.begin(), here = begin + row;
        const auto last = std::find_if(here, lights_.shapes.end(), is_another);
        const auto first = std::find_if(std::make_reverse_iterator(here), lights_.shapes.rend(), is_another).base();
        return {{"cell", here - first}, {"cells", last - first}};
    }
    return {{"column", cell & 0xff}, {"row", cell >> 8 & 0xff}, {"rows", cell >> 16}};
}

json SceneObjects::light(uint row) {
    const char *kind = light_kinds()[lights_.rows[row].kind].name;
    const PlacedShape &emissive = lights_.shapes[row];
    const json number = row < scene_.lights.size() ? json(row) : json(nullptr);
    if (!emissive.shape) return {{"row", row}, {"kind", kind}, {"light", number}, {"emissive", nullptr}};
    json result = shape(shapes_[place_of_shape_.at(emissive.shape)]);
    result["instance"] = instance(emissive.instance);
    result["material"] = scene_.materials[emissive.material].name;
    result["stratum"] = stratum(row);
    return {{"row", row}, {"kind", kind}, {"light", nullptr}, {"emissive", result}};
}

}  // namespace brandung
