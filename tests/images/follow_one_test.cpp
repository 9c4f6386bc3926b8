/// Following one of two rays, chosen at random, shows in the mean what following both does.
#include <gtest/gtest.h>

#include "scene/formats/format.h"
#include "tests/support/rendering.h"
#include "tests/support/statistics/blocks.h"
#include "tests/support/statistics/significance.h"

namespace brandung {
namespace {

std::vector<statistics::Estimate> blocks(const std::string &follow, const std::string &spp) {
    const Scene scene = read_scene(BRANDUNG_SOURCE_DIR "/scene/examples/nested_glass.json",
                                   {{"film.width=32", "film.height=24", "film.spp=" + spp, "integrator.follow=" + follow}, {}, {}});
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.refused, 0u);
    std::vector<statistics::Estimate> all;
    for (const std::size_t channel : {0, 1, 2})
        for (const statistics::Estimate &block : statistics::estimates_of_blocks(rendering.film, 32, {8, 8}, channel)) all.push_back(block);
    return all;
}

/// Glass, water and air in each other, whose lists of media must follow the ray that is chosen.
TEST(FollowOne, HasTheMeansOfFollowingBoth) {
    EXPECT_TRUE(statistics::plausible(statistics::p_of_differences(blocks("one", "1024"), blocks("both", "64"))));
}

}  // namespace
}  // namespace brandung
