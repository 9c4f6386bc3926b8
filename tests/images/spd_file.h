/// What an NFF file holds, for the reference that counts rays.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace spd {

using Vec = glm::dvec3;

struct Surface {
    double reflection = 0, transmission = 0, index = 1;
};

enum class Kind { ball, cone, polygon };

struct Thing {
    Kind kind;
    unsigned surface;
    Vec center;      ///< ball
    double radius;   ///< ball; cone: at its base
    Vec base, axis;  ///< cone: from base to apex, unit length
    double height, slope;
    std::vector<Vec> corners, normals;  ///< polygon
    Vec normal;                         ///< polygon: to its outside
    double constant;                    ///< of its plane
    int u, v;                           ///< the two axes on which its shadow is largest
};

struct Contents {
    Vec from, at, up;
    double angle = 45;
    std::vector<Vec> lights;
    std::vector<Surface> surfaces;
    std::vector<Thing> things;
};

/// Throws std::runtime_error.
Contents read(const std::string &name);

}  // namespace spd
