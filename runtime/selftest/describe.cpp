#include "runtime/selftest/describe.h"

#include <fmt/format.h>

#include <cstring>

namespace brandung {
namespace {

/// The lane's value in every column of floats.
std::string columns_of(const CrossingCases &cases, std::size_t i) {
    const Lane lane = cases.lane(i);
    std::string text;
    for (std::size_t column = 1; column < cases.block_bytes / (BLOCK_SIZE * sizeof(float)); ++column) {
        float value;
        std::memcpy(&value, lane.block + (column * BLOCK_SIZE + lane.lane) * sizeof value, sizeof value);
        text += fmt::format(" {:a}", value);
    }
    return text;
}

}  // namespace

std::string text_of(vec3 v) { return fmt::format("({:a}, {:a}, {:a})", v.x, v.y, v.z); }

std::string describe_case(const CrossingCases &cases, std::size_t i, uint round) {
    const Ray &ray = cases.rays[i];
    return fmt::format("; round {}, input {}: ray from {} in direction {} to t {:a}, columns of the primitive{}", round, i, text_of(ray.origin),
                       text_of(ray.direction), ray.t_max, columns_of(cases, i));
}

}  // namespace brandung
