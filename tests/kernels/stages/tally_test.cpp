/// kernels/core/tally.cl, and what runtime/wavefront/ray_counter.h makes of it.
#include <gtest/gtest.h>

#include "runtime/wavefront/ray_counter.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

TEST(Tally, LaunchesAddUpBeyond32Bits) {
    Random random(1);
    std::vector<Tally> before(100), seen(100);
    RayCounts expected;
    for (std::vector<Tally> *tallies : {&before, &seen})
        for (Tally &tally : *tallies)
            for (uint kind = 0; kind < RAY_KINDS; ++kind) {
                expected.rays[kind] += tally.rays[kind] = 0xf0000000u + random.below(1000);
                expected.hits[kind] += tally.hits[kind] = random.below(0xffffffffu);
            }
    RayCounter counter(test_device(), 100);
    counter.tallies().write(Probe(R"(#include "kernels/core/tally.cl"
        kernel void probe(const global Tally *before, const global Tally *seen, global Tally *sums) {
            sums[get_global_id(0)] = before[get_global_id(0)];
            add_tally(sums + get_global_id(0), seen[get_global_id(0)]);
        })")
                                .run<Tally>(before, seen));
    EXPECT_EQ(counter.read().rays, expected.rays);
    EXPECT_EQ(counter.read().hits, expected.hits);
    EXPECT_EQ(counter.read().total(), expected.rays[0] + expected.rays[1] + expected.rays[2] + expected.rays[3]);
}

}  // namespace
}  // namespace brandung
