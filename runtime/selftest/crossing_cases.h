/// Pairs of one primitive and one ray, of all the kinds that are hard.
#pragma once
#include <vector>

#include "kernels/core/items.h"
#include "kernels/core/scene.h"
#include "kernels/primitives/smooth_triangle.h"
#include "runtime/selftest/oracle.h"

namespace brandung {

/// Primitive i is lane i % BLOCK_SIZE of block i / BLOCK_SIZE.
struct CrossingCases {
    std::size_t block_bytes;
    std::vector<std::byte> blocks;
    std::vector<ShadingRecord> records;
    std::vector<VertexNormals> normals;
    std::vector<float> extents;  ///< largest magnitude of a coordinate of the primitive's bounds
    std::vector<Ray> rays;
    Lane lane(std::size_t i) const { return {blocks.data() + i / BLOCK_SIZE * block_bytes, static_cast<uint>(i % BLOCK_SIZE)}; }
};

/// How large primitives are and how far from the origin.
struct Placing {
    float size;
    int offset_bits;  ///< up to 2^offset_bits sizes
};

/// A place and a size for one primitive.
using ChoosePlacing = Placing (*)(InputSource &);
/// A ray that is aimed at a primitive of some size.
using ChooseRay = Ray (*)(InputSource &, Aim, float size);

CrossingCases make_cases(const PrimitiveOracle &oracle, std::size_t count, std::uint64_t seed, ChoosePlacing placing, ChooseRay ray);

/// Sizes from 10^-12 to 10^12, most about 10^-6, 1 and 10^6; up to 2^20 sizes from the origin.
Placing any_placing(InputSource &source);
/// From near, far, inside and on the surface; grazing, axis-parallel, with subnormal components, or aimed at nothing; of any length, and with or
/// without an end near the aim.
Ray any_ray(InputSource &source, Aim aim, float size);
/// Of unit length, from up to 100 sizes away, or from within.
Ray meeting_ray(InputSource &source, Aim aim, float size);

}  // namespace brandung
