#include "tests/images/spd_file.h"

#include <fstream>
#include <stdexcept>

namespace spd {
namespace {

class File {
public:
    explicit File(const std::string &name) : stream_(name) {
        if (!stream_) throw std::runtime_error("cannot read " + name);
    }
    bool word(std::string &text) { return static_cast<bool>(stream_ >> text); }
    double number() {
        double value = 0;
        if (!(stream_ >> value)) throw std::runtime_error("number expected");
        return value;
    }
    Vec vector() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    std::string rest_of_line() {
        std::string text;
        std::getline(stream_, text);
        return text;
    }

private:
    std::ifstream stream_;
};

Thing read_polygon(File &file, unsigned surface, bool patch) {
    Thing thing{.kind = Kind::polygon, .surface = surface};
    const int count = static_cast<int>(file.number());
    for (int i = 0; i < count; ++i) {
        thing.corners.push_back(file.vector());
        if (patch) thing.normals.push_back(file.vector());
    }
    if (patch && count != 3) throw std::runtime_error("a patch that is no triangle");
    // Newell's normal, which any order of corners defines.
    Vec normal(0);
    for (int i = 0; i < count; ++i) normal += glm::cross(thing.corners[i], thing.corners[(i + 1) % count]);
    thing.normal = glm::normalize(normal);
    thing.constant = glm::dot(thing.normal, thing.corners[0]);
    const Vec size = glm::abs(thing.normal);
    const int w = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    thing.u = (w + 1) % 3, thing.v = (w + 2) % 3;
    return thing;
}

Thing read_cone(File &file, unsigned surface) {
    Thing thing{.kind = Kind::cone, .surface = surface};
    thing.base = file.vector();
    thing.radius = file.number();
    const Vec apex = file.vector();
    const double apex_radius = file.number();
    thing.height = glm::length(apex - thing.base);
    thing.axis = (apex - thing.base) / thing.height;
    thing.slope = (apex_radius - thing.radius) / thing.height;
    return thing;
}

}  // namespace

Contents read(const std::string &name) {
    File file(name);
    Contents scene;
    for (std::string word; file.word(word);) {
        const auto surface = static_cast<unsigned>(scene.surfaces.size()) - 1;
        if (word[0] == '#' || word == "b" || word == "hither" || word == "resolution") {
            file.rest_of_line();
        } else if (word == "from") {
            scene.from = file.vector();
        } else if (word == "at") {
            scene.at = file.vector();
        } else if (word == "up") {
            scene.up = file.vector();
        } else if (word == "angle") {
            scene.angle = file.number();
        } else if (word == "l") {
            scene.lights.push_back(file.vector());
            file.rest_of_line();
        } else if (word == "f") {
            for (int i = 0; i < 4; ++i) file.number();
            Surface read;
            read.reflection = file.number();
            file.number();
            read.transmission = file.number(), read.index = file.number();
            scene.surfaces.push_back(read);
        } else if (word == "s") {
            Thing thing{.kind = Kind::ball, .surface = surface};
            thing.center = file.vector(), thing.radius = file.number();
            scene.things.push_back(thing);
        } else if (word == "c") {
            scene.things.push_back(read_cone(file, surface));
        } else if (word == "p" || word == "pp") {
            scene.things.push_back(read_polygon(file, surface, word == "pp"));
        } else if (word != "v") {
            throw std::runtime_error("unknown entity " + word);
        }
    }
    return scene;
}

}  // namespace spd
