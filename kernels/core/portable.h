/// Types that mean the same in OpenCL C and C++, so that one header declares a record for both.
/// Stored records consist of 4-byte scalars and structs of floats: no compiler can pad them.
#pragma once

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
using uint = std::uint32_t;
using int64 = std::int64_t;
using uint64 = std::uint64_t;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
#else
// Contraction would make an edge of a triangle differ from its neighbour's; fma is written where it is wanted.
#pragma OPENCL FP_CONTRACT OFF
typedef long int64;
typedef ulong uint64;
typedef struct {
    float x, y;
} vec2;
typedef struct {
    float x, y, z;
} vec3;
// The x86-64 ABI passes three floats as <2 x float> and float, and what is left of that after inlining keeps the compiler from vectorising
// loops over items; regcall passes every member on its own.
#ifdef __x86_64__
#define FUNCTION static inline __attribute__((always_inline, overloadable, regcall))
#else
#define FUNCTION static inline __attribute__((always_inline, overloadable))
#endif
#endif

/// Items that one work-item of a stage handles on a CPU; elsewhere it is one.
#define ITEMS_PER_CHUNK 64u

/// Radiance [W/(m² sr)], reflectance or throughput: linear Rec. 709 red, green, blue.
typedef vec3 Spectrum;
