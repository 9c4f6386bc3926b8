/// Headers of PLY files (G. Turk, 1994): which elements follow, and of what properties each consists.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat { ascii, little_endian, big_endian };

uint bytes_of(PlyType type);
bool is_float(PlyType type);
bool is_signed(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count;  ///< of the number of a list's values; a single value has none
};

struct PlyElement {
    std::string name;
    uint64 count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::vector<std::string> comments;
    std::size_t bytes = 0;  ///< of the header
    uint lines = 0;         ///< of the header
};

/// Throws SceneError `file:line: why`.
PlyHeader read_ply_header(const std::string &file, const std::string &text);

}  // namespace brandung
