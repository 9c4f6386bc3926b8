#include "runtime/selftest/crossing_cases.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

#include "runtime/selftest/examine.h"

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

float extent_of(const Bounds &bounds) {
    const vec3 far = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    return std::max({far.x, far.y, far.z});
}

std::unique_ptr<Shape> make_shape(const PrimitiveOracle &oracle, InputSource &source, Placing placing) {
    for (;;) {
        const vec3 place = source.one_in(8) ? vec3(0) : source.direction() * (placing.size * source.power_of_two(-2, placing.offset_bits));
        if (auto shape = oracle.make(source, place, placing.size)) return shape;
    }
}

/// Two directions across a third one.
vec3 across(InputSource &source, vec3 n) {
    const vec3 other = glm::cross(n, source.direction());
    return glm::length(other) > 0 ? glm::normalize(other) : vec3(0, 0, 1);
}

vec3 axis_direction(InputSource &source) {
    vec3 axis(source.one_in(2) ? 0.0f : -0.0f);
    axis[int(source.below(3))] = source.sign();
    return axis;
}

vec3 from_to(vec3 origin, vec3 target) { return vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin))); }

struct Line {
    vec3 origin, direction;
};

Line straight_at(vec3 origin, vec3 target) { return {origin, from_to(origin, target)}; }

Line towards(InputSource &source, Aim aim, float size) {
    return straight_at(aim.point + source.direction() * (size * source.power_of_two(-4, 12)), aim.point);
}
Line from_afar(InputSource &source, Aim aim, float size) {
    return straight_at(aim.point + source.direction() * (size * source.power_of_two(12, 20)), aim.point);
}
Line grazing(InputSource &source, Aim aim, float size) {
    const vec3 beside = across(source, aim.normal) * (size * source.power_of_two(-3, 10));
    return straight_at(aim.point + beside + aim.normal * (source.sign() * size * source.power_of_two(-32, 0)), aim.point);
}
Line from_within(InputSource &source, Aim aim, float size) {
    const vec3 origin = aim.point - aim.normal * (size * source.uniform(0, 1.5));
    return source.one_in(2) ? straight_at(origin, aim.point) : Line{origin, source.direction()};
}
Line from_the_surface(InputSource &source, Aim aim, float size) {
    const float height = source.one_in(4) ? 0.0f : source.sign() * size * source.power_of_two(-40, -12);
    return {aim.point + aim.normal * height, source.direction()};
}
Line along_an_axis(InputSource &source, Aim aim, float size) {
    const vec3 direction = axis_direction(source);
    return {aim.point - direction * (size * source.power_of_two(-4, 12)), direction};
}
Line with_subnormal_parts(InputSource &source, Aim aim, float size) {
    vec3 direction = axis_direction(source);
    for (int i = 0; i < 3; ++i)
        if (direction[i] == 0) direction[i] = source.subnormal();
    vec3 origin = aim.point - direction * (size * source.power_of_two(-4, 4));
    if (source.one_in(2)) origin[int(source.below(3))] = source.subnormal();
    return {origin, direction};
}
Line at_nothing(InputSource &source, Aim aim, float size) {
    return {aim.point + source.direction() * (size * source.power_of_two(-4, 12)), source.direction()};
}

constexpr Line (*lines[])(InputSource &, Aim, float) = {
    towards, towards, from_afar, grazing, from_within, from_the_surface, along_an_axis, with_subnormal_parts, at_nothing};

}  // namespace

Placing any_placing(InputSource &source) {
    const float scales[] = {0x1p-20f, 1, 0x1p20f};
    if (source.one_in(8)) return {source.power_of_two(-40, 40), source.one_in(2) ? 0 : 4};
    const int offsets[] = {2, 10, 20};
    return {scales[source.below(3)] * source.uniform(0.5, 1), offsets[source.below(3)]};
}

Ray any_ray(InputSource &source, Aim aim, float size) {
    for (;;) {
        auto [origin, direction] = lines[source.below(std::size(lines))](source, aim, size);
        if (!(glm::length(direction) > 0.5f)) continue;
        if (source.one_in(4)) direction *= source.power_of_two(-8, 8);
        const float end = source.one_in(4) ? glm::length(aim.point - origin) / glm::length(direction) * (1 + source.beside()) : infinity;
        return {.origin = origin, .t_max = end, .direction = direction, .tag = RAY_TAG(RAY_CAMERA, NO_HIT)};
    }
}

Ray meeting_ray(InputSource &source, Aim aim, float size) {
    const vec3 inside = aim.point - aim.normal * (size * source.uniform(0, 1)),
               outside = aim.point + source.direction() * (size * source.uniform(1, 100));
    const vec3 origin = source.one_in(2) ? inside : outside;
    const vec3 direction = origin == aim.point ? aim.normal : from_to(origin, aim.point);
    return {.origin = origin, .t_max = infinity, .direction = direction, .tag = RAY_TAG(RAY_CAMERA, NO_HIT)};
}

CrossingCases make_cases(const PrimitiveOracle &oracle, std::size_t count, std::uint64_t seed, ChoosePlacing placing, ChooseRay ray) {
    const std::size_t block_bytes = oracle.kind().block_bytes;
    std::vector<std::unique_ptr<Shape>> shapes(count);
    std::vector<float> sizes(count);
    CrossingCases cases{block_bytes, {}, std::vector<ShadingRecord>(count), {}, std::vector<float>(count), std::vector<Ray>(count)};
    cases.blocks.resize((count + BLOCK_SIZE - 1) / BLOCK_SIZE * block_bytes, std::byte{0xff});
    for_parts(count, [&](std::size_t first, std::size_t last) {
        InputSource source(seed_of(seed, 0, first));
        for (std::size_t i = first; i < last; ++i) {
            const Placing place = placing(source);
            shapes[i] = make_shape(oracle, source, place);
            sizes[i] = place.size;
            std::byte *block = cases.blocks.data() + i / BLOCK_SIZE * block_bytes;
            const uint number = static_cast<uint>(i);
            std::memcpy(block + i % BLOCK_SIZE * sizeof number, &number, sizeof number);  // a block's first column
            shapes[i]->write_lane(0, static_cast<uint>(i % BLOCK_SIZE), block);
            cases.extents[i] = extent_of(shapes[i]->bounds(0));
        }
    });
    SharedTables tables;
    for (std::size_t i = 0; i < count; ++i) shapes[i]->write_shading(0, cases.records[i].words, tables);
    cases.normals = std::move(tables.vertex_normals);
    for_parts(count, [&](std::size_t first, std::size_t last) {
        InputSource source(seed_of(seed, 1, first));
        for (std::size_t i = first; i < last; ++i) cases.rays[i] = ray(source, oracle.aim(source, cases.lane(i)), sizes[i]);
    });
    return cases;
}

}  // namespace brandung
