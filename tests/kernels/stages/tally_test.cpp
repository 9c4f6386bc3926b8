/// kernels/stages/tally.cl, as runtime/wavefront/ray_counter.h runs it.
#include <gtest/gtest.h>

#include "runtime/wavefront/ray_counter.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

TEST(Tally, LaunchesAddUpBeyond32Bits) {
    RayCounter counter(test_device(), 100);
    Random random(1);
    RayCounts expected;
    for (const uint work_items : {100u, 1u, 37u}) {
        std::vector<Tally> tallies(100);
        for (uint i = 0; i < 100; ++i)
            for (uint kind = 0; kind < RAY_KINDS; ++kind) {
                tallies[i].rays[kind] = 0xf0000000u + random.below(1000), tallies[i].hits[kind] = random.below(0xffffffffu);
                if (i < work_items) expected.rays[kind] += tallies[i].rays[kind], expected.hits[kind] += tallies[i].hits[kind];
            }
        counter.tallies().write(tallies);
        counter.add(work_items);
    }
    EXPECT_EQ(counter.read().rays, expected.rays);
    EXPECT_EQ(counter.read().hits, expected.hits);
    EXPECT_EQ(counter.read().total(), expected.rays[0] + expected.rays[1] + expected.rays[2] + expected.rays[3]);
}

}  // namespace
}  // namespace brandung
