/// What report.h gives, as text for people.
#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "kernels/core/portable.h"

namespace brandung {

/// "1 light", "2 emissive meshes": names of kinds may have underscores.
std::string counted(std::uint64_t count, std::string noun);
inline double mebibytes(std::uint64_t bytes) { return double(bytes) / (1 << 20); }
/// "1.5 MiB (1572864 bytes)"
std::string bytes_text(std::uint64_t bytes);
/// Of scene_contents(): "6 primitives (2 spheres, 4 triangles), 1 light (1 point), 2 materials, 1 camera, 3 instances of 1 group".
std::string contents_text(const nlohmann::json &contents);
/// A line for each: "warning: triangle without area: left out (2 times, first at scene.json:12: /objects/3)"; not all have places.
std::string warnings_text(const std::map<std::string, uint> &warnings, const std::map<std::string, std::string> &places);

}  // namespace brandung
