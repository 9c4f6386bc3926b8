/// Small scenes for runs of the program.
#pragma once
#include <string>

/// One sphere, one light, in the native format; `objects` and `more` are put into it as they are.
inline std::string native_scene(const std::string &objects = R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1})",
                                const std::string &more = "") {
    return R"({
  "film": {"width": 32, "height": 24, "spp": 1},
  "camera": {"from": [0, 0, 4], "at": [0, 0, 0], "fov": 40},
  "ambient": 0.1,
  "materials": [{"name": "grey", "type": "whitted", "diffuse": 0.5}],
  "lights": [{"type": "point", "position": [2, 3, 4], "intensity": 30}],)" +
           more + R"(
  "objects": [
    )" + objects +
           R"(
  ]
}
)";
}

/// The same in NFF; `objects` begin on line 10.
inline std::string nff_scene(const std::string &objects = "s 0 0 0 1\n") {
    return "b 0.1 0.2 0.3\n"
           "v\n"
           "from 0 0 4\n"
           "at 0 0 0\n"
           "up 0 1 0\n"
           "angle 40\n"
           "resolution 32 24\n"
           "l 2 3 4\n"
           "f 0.5 0.5 0.5 1 0 1 0 1\n" +
           objects;
}
