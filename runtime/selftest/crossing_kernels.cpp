#include "runtime/selftest/crossing_kernels.h"

#include <fmt/format.h>

#include <cstring>
#include <span>

namespace brandung {
namespace {

/// kernels/core/items.h's, with doubles.
struct RayInDouble {
    double origin[3], t_max, direction[3];
    uint tag;
};

RayInDouble widened(const Ray &ray) {
    const vec3 o = ray.origin, d = ray.direction;
    return {{o.x, o.y, o.z}, ray.t_max, {d.x, d.y, d.z}, ray.tag};
}

std::vector<double> widened(std::span<const float> floats) { return {floats.begin(), floats.end()}; }

std::span<const float> floats_of(const std::byte *bytes, std::size_t size) { return {reinterpret_cast<const float *>(bytes), size / sizeof(float)}; }

/// Blocks begin with the primitives' numbers; columns of floats follow.
std::vector<std::byte> widened_blocks(const CrossingCases &cases) {
    constexpr std::size_t numbers = BLOCK_SIZE * sizeof(uint);
    const std::size_t blocks = cases.blocks.size() / cases.block_bytes, columns = cases.block_bytes - numbers;
    std::vector<std::byte> wide(blocks * (numbers + 2 * columns));
    std::byte *to = wide.data();
    for (const std::byte *from = cases.blocks.data(); from != cases.blocks.data() + cases.blocks.size(); from += cases.block_bytes) {
        const std::vector<double> doubles = widened(floats_of(from + numbers, columns));
        std::memcpy(to, from, numbers);
        std::memcpy(to + numbers, doubles.data(), 2 * columns);
        to += numbers + 2 * columns;
    }
    return wide;
}

uint count_of(const CrossingCases &cases) { return static_cast<uint>(cases.rays.size()); }

}  // namespace

Sources one_kind(const PrimitiveKind &kind) {
    const std::string path = fmt::format("#include \"kernels/primitives/{}", kind.name);
    return {{"generated/constants.h", "#pragma once\n#define INTERIOR_SIZE 0u\n#define INSTANCES 0\n"},
            {"generated/time.cl", "#include \"kernels/core/no_time.cl\"\n"},
            {"generated/work.cl", "#include \"kernels/accelerators/no_work.cl\"\n"},
            {"generated/precision.cl", "// float\n"},
            {"generated/kind.cl",
             fmt::format("#pragma once\n{}.h\"\n#define NAME(function) {}_##function\n#define HAS_VERTICES {}\ntypedef {}Block Block;\n", path,
                         kind.name, int(kind.has_vertices), kind.record)},
            {"generated/primitive_hits.cl", path + "_hit.cl\"\n"},
            {"generated/primitive_surfaces.cl", "#pragma once\n" + path + ".cl\"\n"}};
}

NormalsOnly::NormalsOnly(Device &device, const CrossingCases &cases) : header_(device, 1), normals_(device, cases.normals) { header_.fill_zero(); }

CrossingKernels::CrossingKernels(Device &device, const PrimitiveKind &kind)
    : device_(device),
      crossings_(device, "kernels/selftest/crossings.cl", "test_crossings", one_kind(kind)),
      widths_(device, "kernels/selftest/widths.cl", "test_widths", one_kind(kind)) {}

std::vector<CrossingResult<float>> CrossingKernels::in_float(const CrossingCases &cases) {
    Buffer<CrossingResult<float>> results(device_, cases.rays.size());
    crossings_.in_float(cases.rays.size(), NormalsOnly(device_, cases), Buffer<std::byte>(device_, cases.blocks),
                        Buffer<ShadingRecord>(device_, cases.records), Buffer<float>(device_, cases.extents), Buffer<Ray>(device_, cases.rays),
                        count_of(cases), results);
    return results.read();
}

std::optional<std::vector<CrossingResult<double>>> CrossingKernels::in_double(const CrossingCases &cases) {
    if (!crossings_.in_double) return std::nullopt;
    const std::vector<double> extents = widened(cases.extents);
    const std::vector<double> normals =
        widened(floats_of(reinterpret_cast<const std::byte *>(cases.normals.data()), cases.normals.size() * sizeof(VertexNormals)));
    std::vector<RayInDouble> rays;
    for (const Ray &ray : cases.rays) rays.push_back(widened(ray));
    Buffer<CrossingResult<double>> results(device_, cases.rays.size());
    (*crossings_.in_double)(cases.rays.size(), empty_header(device_), Buffer<double>(device_, normals),
                            Buffer<std::byte>(device_, widened_blocks(cases)), Buffer<ShadingRecord>(device_, cases.records),
                            Buffer<double>(device_, extents), Buffer<RayInDouble>(device_, rays), count_of(cases), results);
    return results.read();
}

std::vector<std::uint8_t> CrossingKernels::differences(const CrossingCases &cases) {
    Buffer<std::uint8_t> results(device_, cases.rays.size());
    widths_(cases.rays.size(), Buffer<std::byte>(device_, cases.blocks), Buffer<float>(device_, cases.extents), Buffer<Ray>(device_, cases.rays),
            count_of(cases), results);
    return results.read();
}

}  // namespace brandung
