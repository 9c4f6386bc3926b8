/// runtime/schedule.
#include "runtime/schedule.h"

#include <gtest/gtest.h>

#include <limits>

namespace brandung {
namespace {

FilmSettings film_of(uint spp, uint side = 256) {
    FilmSettings film;
    film.width = film.height = side, film.spp = spp;
    return film;
}

/// Passes until the end, where the noise of n samples is given and each takes a second.
std::vector<uint> passes(Schedule schedule, double (*relmse)(double samples)) {
    std::vector<uint> all;
    uint done = 0;
    for (uint pass = schedule.next_pass(); pass > 0; pass = schedule.next_pass()) {
        all.push_back(pass), done += pass;
        const double value = relmse(done);
        schedule.end_pass(pass, done, done > 1 ? std::optional(Noise{value, 0.95 * value, 1.05 * value}) : std::nullopt);
    }
    EXPECT_EQ(schedule.samples_done(), done);
    return all;
}

double independent(double samples) { return 1 / samples; }
double stratified(double samples) { return 1 / (samples * samples); }
uint sum(const std::vector<uint> &all) {
    uint total = 0;
    for (const uint pass : all) total += pass;
    return total;
}

TEST(Schedule, OfManySamplesTheFirstPassTakesOneAndTheOthersFew) {
    EXPECT_EQ(passes({film_of(16), 32768, {}}, independent), (std::vector<uint>{16}));
    EXPECT_EQ(passes({film_of(40), 32768, {}}, independent), (std::vector<uint>{1, 16, 16, 7}));
}

/// 64 pixels: a batch has 512 samples of each.
TEST(Schedule, SmallPicturesAreInEveryBatch) { EXPECT_EQ(passes({film_of(1000, 8), 32768, {}}, independent), (std::vector<uint>{512, 488})); }

/// 1/n is below 0.01 with 5 % of uncertainty from 105 samples on; steps are at most a sixteenth of what is done, and two.
TEST(Schedule, EndsSoonAfterTheErrorIsReached) {
    for (const uint side : {8u, 256u}) {
        const uint taken = sum(passes({film_of(1u << 24, side), 32768, {.error = 0.01, .seconds = {}}}, independent));
        EXPECT_GE(taken, 105u) << side;
        EXPECT_LE(taken, 114u) << side;
        // 1.05 / n² = 0.0001 at n = 102.5.
        const uint fewer = sum(passes({film_of(1u << 24, side), 32768, {.error = 0.0001, .seconds = {}}}, stratified));
        EXPECT_GE(fewer, 103u) << side;
        EXPECT_LE(fewer, 112u) << side;
    }
}

TEST(Schedule, PassesTowardsAnErrorAreEven) {
    for (const uint pass : passes({film_of(1u << 24), 32768, {.error = 0.003, .seconds = {}}}, independent)) EXPECT_EQ(pass % 2, 0u);
}

TEST(Schedule, SppIsTheLimit) { EXPECT_EQ(sum(passes({film_of(37), 32768, {.error = 1e-6, .seconds = {}}}, independent)), 37u); }

TEST(Schedule, NoiseThatIsNotFiniteIsNotKnown) {
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Schedule schedule(film_of(64), 32768, {.error = 0.1, .seconds = {}});
        for (uint pass = schedule.next_pass(); pass > 0; pass = schedule.next_pass()) schedule.end_pass(pass, 1, Noise{value, 0, value});
        EXPECT_EQ(schedule.samples_done(), 64u);
        EXPECT_FALSE(schedule.has_reached_error());
    }
}

TEST(Schedule, KnowsWhenItIsLateButNotBeforeEveryPixelHasASample) {
    Schedule schedule(film_of(1u << 24), 32768, {.error = {}, .seconds = 10});
    EXPECT_EQ(schedule.next_pass(), 1u);
    EXPECT_FALSE(schedule.is_late(11));
    schedule.end_pass(1, 4, {});
    EXPECT_EQ(schedule.next_pass(), 1u) << "as many as there are, so that all pixels have about as many";
    EXPECT_FALSE(schedule.is_late(9.9));
    EXPECT_TRUE(schedule.is_late(10));
    EXPECT_EQ(schedule.seconds_left(7), 3);
    EXPECT_EQ(schedule.part(0.001, 7), 0.7);
}

TEST(Schedule, TimeCountsFromTheFirstBatch) {
    Schedule schedule(film_of(1u << 24), 32768, {.error = {}, .seconds = 10});
    schedule.start_clock(100);
    schedule.end_pass(1, 101, {});
    EXPECT_FALSE(schedule.is_late(109.9));
    EXPECT_TRUE(schedule.is_late(110));
    EXPECT_EQ(schedule.seconds_left(107), 3);
    EXPECT_EQ(schedule.part(0.001, 107), 0.7);
}

/// With noise 0.04 of 25 samples and of 0.02 of 50 the slope is 1: 0.01 is reached at 105 with its uncertainty, 55 samples of a second each from now.
TEST(Schedule, TimeLeftFollowsFromTheConvergence) {
    Schedule schedule(film_of(1u << 24), 32768, {.error = 0.01, .seconds = {}});
    EXPECT_FALSE(schedule.seconds_left(0));
    schedule.end_pass(5, 105, {});  // kernels were compiled
    schedule.end_pass(20, 125, Noise{0.04, 0.038, 0.042});
    schedule.end_pass(25, 150, Noise{0.02, 0.019, 0.021});
    EXPECT_NEAR(schedule.seconds_left(150).value(), 55, 1e-9);
    EXPECT_NEAR(schedule.part(0.001, 150), 50.0 / 105, 1e-9);
}

}  // namespace
}  // namespace brandung
