/// The kernels under kernels/selftest/ that cross one primitive with one ray, and records that their structs mirror.
#pragma once
#include <optional>
#include <vector>

#include "runtime/selftest/crossing_cases.h"
#include "runtime/selftest/precision.h"

namespace brandung {

/// As kernels/selftest/crossings.cl has it, in float or in double.
template <class Number> struct CrossingResult {
    Number t, u, v;
    Number p[3], error[3], geometric[3], normal[3], lift[3], uv[2];
    uint hit;
};

/// Bits of the results of other widths.
inline constexpr std::uint8_t differs_at_8 = 1, differs_at_16 = 2;

class CrossingKernels {
public:
    /// Builds them. Throws Error.
    CrossingKernels(Device &device, const PrimitiveKind &kind);

    std::vector<CrossingResult<float>> in_float(const CrossingCases &cases);
    /// Nothing where the device has no doubles.
    std::optional<std::vector<CrossingResult<double>>> in_double(const CrossingCases &cases);
    /// Per pair, at which widths the bits of the crossing are other ones.
    std::vector<std::uint8_t> differences(const CrossingCases &cases);

private:
    Device &device_;
    KernelInBoth crossings_;
    Kernel widths_;
};

/// SCENE_PARAMS of a scene that has nothing but the cases' normals.
class NormalsOnly {
public:
    NormalsOnly(Device &device, const CrossingCases &cases);
    template <class Bind> void for_each_argument(Bind bind) const { bind(header_), bind(normals_); }

private:
    Buffer<SceneHeader> header_;
    Buffer<VertexNormals> normals_;
};

/// The generated files that these kernels need: of this kind, in float.
Sources one_kind(const PrimitiveKind &kind);

}  // namespace brandung
