/// kernels/samplers/part.cl, with Sobol's points.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "kernels/core/params.h"
#include "tests/support/probe.h"

namespace brandung {
namespace {

/// Pairs of part i % parts of sample 2 (i / parts) of one pixel, for i < count.
std::vector<vec2> pairs_of_parts(uint parts, uint count) {
    std::vector<uint> numbers(count);
    for (uint i = 0; i < count; ++i) numbers[i] = i;
    const BatchParams batch{.pixels = 0, .first_sample = 0, .samples = 0, .spp = 2, .seed = 9, .position = PIXEL_CENTER};
    return Probe(R"(#include "kernels/samplers/sobol.cl"
        kernel void probe(const global uint *numbers, const global uint *parts, const global BatchParams *batch, global vec2 *pairs) {
            const uint i = get_global_id(0), sample = 2u * (numbers[i] / *parts);
            pairs[i] = sampler_pair(0x2d007bu, sample, part(numbers[i] % *parts, *parts), 3u, *batch);
        })")
        .run<vec2>(numbers, parts, batch);
}

}  // namespace

/// As if each were a sample.
TEST(Parts, EveryBoxHasOneOfASamplesPartsAndOfAllSamplesTogether) {
    for (const uint parts : {1u, 4u, 16u}) {
        const std::vector<vec2> pairs = pairs_of_parts(parts, 256);
        for (const uint k : {0u, 2u, 4u, 8u}) {
            const uint n = 1u << k;
            if (n % parts != 0) continue;
            for (std::size_t first = 0; first < pairs.size(); first += n)
                for (uint a = 0; a <= k; ++a) {
                    std::set<uint> boxes;
                    for (std::size_t i = first; i < first + n; ++i)
                        boxes.insert(uint(std::ldexp(pairs[i].x, int(a))) | uint(std::ldexp(pairs[i].y, int(k - a))) << 16);
                    ASSERT_EQ(boxes.size(), n) << parts << " parts from " << first << ", " << a << " of " << k;
                }
        }
    }
}

/// A sample without parts has the numbers of its only one; bundles of other sizes have others.
TEST(Parts, OfAnotherCountHaveOtherNumbers) {
    const std::vector<vec2> two = pairs_of_parts(2, 64), four = pairs_of_parts(4, 64);
    for (std::size_t i = 0; i < two.size(); ++i)
        for (const vec2 &other : four) ASSERT_NE(two[i], other) << i;
}

TEST(Parts, PlacesLieOneInEachInterval) {
    for (const uint count : {1u, 2u, 3u, 7u, 100u, 1024u})
        for (const float u : {0.0f, 0x1p-24f, 0.3f, 0.5f, 0.99999994f}) {
            std::vector<uint> numbers(count);
            for (uint i = 0; i < count; ++i) numbers[i] = i;
            const std::vector<float> places = Probe(R"(#include "kernels/samplers/part.cl"
                kernel void probe(const global uint *numbers, const global uint *count, const global float *u, global float *places) {
                    places[get_global_id(0)] = place_of_part(part(numbers[get_global_id(0)], *count), *u);
                })")
                                                  .run<float>(numbers, count, u);
            for (uint i = 0; i < count; ++i) {
                ASSERT_NEAR(places[i], (double(i) + double(u)) / count, 1e-7) << i << " of " << count;
                ASSERT_LT(places[i], 1);
            }
            ASSERT_TRUE(count > 1 || places[0] == u);
        }
}

}  // namespace brandung
