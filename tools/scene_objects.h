/// What primitives, instances and rows of lights are in the scene file.
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/document.h"
#include "scene/lights/light_rows.h"

namespace brandung {

class SceneObjects {
public:
    /// `scene` must live as long.
    explicit SceneObjects(const Scene &scene);

    /// A primitive by its number on the device, in an instance or, where that is 0, outside of all.
    nlohmann::json primitive(uint number, uint instance);
    /// A row of lights: a light, a stratum of an emissive shape, or the background.
    nlohmann::json light(uint row);

private:
    /// A shape of the world or of a group in use.
    struct Placed {
        uint first;  ///< its first primitive's number on the device
        const Shape *shape;
        std::optional<uint> group;
        uint number;  ///< among those of the world or of the group
    };
    void add_shapes(const std::vector<std::unique_ptr<Shape>> &shapes, std::optional<uint> group, uint &first);
    nlohmann::json shape(const Placed &placed);
    nlohmann::json instance(uint number);
    nlohmann::json stratum(uint row) const;
    nlohmann::json place(std::optional<uint> group, uint object);
    nlohmann::json source(const Shape &shape, uint primitive) const;
    std::string place_in_file(const std::string &pointer);

    const Scene &scene_;
    std::vector<Placed> shapes_;
    std::map<const Shape *, std::size_t> place_of_shape_;  ///< in shapes_
    const LightRows lights_;
    std::optional<Document> document_;           ///< read when a place is asked for
    std::map<std::string, std::string> places_;  ///< by JSON pointer
};

}  // namespace brandung
