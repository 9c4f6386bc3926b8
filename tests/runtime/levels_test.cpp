#include "runtime/wavefront/levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

/// Which of a wave's children live.
enum class Survival { none, all, half };

struct Case {
    uint batch;
    Branching branching;
    uint generations;
    Survival survival;
    uint start;  ///< items in the first level
};
void PrintTo(const Case &c, std::ostream *out) {
    *out << "batch " << c.batch << ", branching " << c.branching.first << " and " << c.branching.others << ", generations " << c.generations
         << ", survival " << int(c.survival) << ", start " << c.start;
}

/// Plays the wavefront on the host: lists and slots, each slot's item by a number of its own.
class Play {
public:
    explicit Play(const Case &c)
        : case_(c),
          capacity_(std::max({c.batch, c.branching.first, c.branching.others})),
          levels_(test_device(), c.batch, c.branching, c.generations, {.interior_size = 2, .place_words = 1}),
          random_(1) {
        lists_.resize(c.generations), slots_.resize(c.generations, std::vector<std::uint64_t>(capacity_, 0));
    }

    void run() {
        Level &first = levels_.start(case_.start);
        ASSERT_LE(first.rays.size(), capacity_);
        for (uint i = 0; i < case_.start; ++i) slots_[0][i] = make_item(), lists_[0].push_back(i);
        while (const auto wave = levels_.next()) {
            step(*wave);
            if (testing::Test::HasFatalFailure()) return;
        }
        EXPECT_EQ(handed_out_, items_) << "every item is handed out once";
        for (const auto &slots : slots_) EXPECT_TRUE(std::all_of(slots.begin(), slots.end(), [](std::uint64_t item) { return item == 0; }));
    }

    std::size_t bytes_at_most() const { return levels_.bytes_at_most(); }
    std::uint64_t items() const { return items_; }
    std::uint64_t waves() const { return waves_; }
    std::size_t levels_used() const { return deepest_ + 1; }

private:
    std::uint64_t make_item() { return ++items_; }

    void step(const Wave &wave) {
        const uint g = wave.generation;
        ASSERT_LT(g, case_.generations);
        ASSERT_GT(wave.count, 0u);
        ASSERT_LE(wave.count, case_.batch) << "a wave fits the arrays of a batch";
        deepest_ = std::max<std::size_t>(deepest_, g), ++waves_;
        ASSERT_LE(wave.first + wave.count, lists_[g].size()) << "a wave's part of the list has been written";
        std::vector<uint> taken(lists_[g].begin() + wave.first, lists_[g].begin() + wave.first + wave.count);
        for (const uint slot : taken) ASSERT_NE(slots_[g][slot], 0u) << "a slot is handed out once";

        const uint branching = g == 0 ? case_.branching.first : case_.branching.others;
        ASSERT_LE(wave.count, levels_.wave_size(g));
        ASSERT_EQ(wave.children != nullptr, branching > 0 && g + 1 < case_.generations);
        if (wave.children) {
            const uint added = wave.count * branching;
            ASSERT_LE(wave.base + added, capacity_) << "children's slots";
            ASSERT_LE(wave.base + added, wave.children->rays.size());
            if (wave.children->end == 0) lists_[g + 1].clear();
            ASSERT_EQ(lists_[g + 1].size(), wave.children->end) << "the list is appended to";
            std::vector<uint> live;
            for (uint slot = wave.base; slot < wave.base + added; ++slot) {
                ASSERT_EQ(slots_[g + 1][slot], 0u) << "a slot that is needed is not used again";
                if (survives()) live.push_back(slot), slots_[g + 1][slot] = make_item();
            }
            lists_[g + 1].insert(lists_[g + 1].end(), live.begin(), live.end());
            ASSERT_LE(lists_[g + 1].size(), wave.children->live.size());
            levels_.add_children(wave, uint(live.size()));
        }
        for (const uint slot : taken) slots_[g][slot] = 0;
        handed_out_ += wave.count;
    }

    bool survives() { return case_.survival == Survival::all || (case_.survival == Survival::half && random_.below(2)); }

    Case case_;
    uint capacity_;
    Levels levels_;
    Random random_;
    std::vector<std::vector<uint>> lists_;
    std::vector<std::vector<std::uint64_t>> slots_;  ///< by generation: the item in each slot, 0 for none
    std::uint64_t items_ = 0, handed_out_ = 0, waves_ = 0;
    std::size_t deepest_ = 0;
};

class LevelsBounds : public testing::TestWithParam<Case> {};

TEST_P(LevelsBounds, NoLevelOverflowsAndEveryItemIsHandedOutOnce) {
    Play play(GetParam());
    play.run();
    EXPECT_GE(play.bytes_at_most(), play.levels_used() * std::size_t{GetParam().batch} * (sizeof(Ray) + sizeof(Path) + 4 * sizeof(uint)));
}

std::vector<Case> cases() {
    std::vector<Case> result;
    for (const uint batch : {1u, 2u, 3u, 7u, 64u, 1000u})
        for (const uint branching : {0u, 1u, 2u, 3u, 10u})
            for (const uint generations : {1u, 2u, 6u})
                for (const Survival survival : {Survival::none, Survival::all, Survival::half})
                    for (const uint start : {batch, (batch + 1) / 2}) {
                        const bool huge = branching == 10 && survival != Survival::none && generations == 6 && batch > 7;
                        if (!huge && !(branching == 0 && generations > 1))
                            result.push_back({batch, {branching, branching}, generations, survival, start});
                    }
    for (const Survival survival : {Survival::all, Survival::half})
        for (const uint branching : {1u, 2u}) result.push_back({65536, {branching, branching}, 4, survival, 65536});
    result.push_back({100, {2, 2}, 13, Survival::all, 100});
    for (const uint batch : {1u, 7u, 1000u})
        for (const uint first : {1u, 3u, 64u, 1024u})
            for (const Survival survival : {Survival::none, Survival::all, Survival::half}) result.push_back({batch, {first, 1}, 6, survival, batch});
    return result;
}

INSTANTIATE_TEST_SUITE_P(Cases, LevelsBounds, testing::ValuesIn(cases()));

TEST(Levels, ADepthFirstTreeHasAllItsItems) {
    Play play({.batch = 3, .branching = {2, 2}, .generations = 8, .survival = Survival::all, .start = 3});
    play.run();
    EXPECT_EQ(play.items(), 3u * 255u);  // 3 (1 + 2 + ... + 128)
}

TEST(Levels, WithoutBranchingAWaveIsAWholeLevel) {
    Play play({.batch = 1000, .branching = {1, 1}, .generations = 9, .survival = Survival::all, .start = 1000});
    play.run();
    EXPECT_EQ(play.waves(), 9u);
}

TEST(Levels, OnlyTheFirstGenerationBranchesWhereTheOthersDoNot) {
    Play play({.batch = 1000, .branching = {10, 1}, .generations = 4, .survival = Survival::all, .start = 1000});
    play.run();
    EXPECT_EQ(play.items(), 1000u * 31u);
    EXPECT_EQ(play.waves(), 10u * 4u) << "what a hundred send fills a level";
}

TEST(Levels, LaunchesAreFullAsLongAsTheyCanBe) {
    // A binary tree of depth 4 over 65,536 rays has 983,040 items; full launches are at least 16,384, and only the ends of levels are smaller.
    Play play({.batch = 65536, .branching = {2, 2}, .generations = 4, .survival = Survival::all, .start = 65536});
    play.run();
    EXPECT_EQ(play.items(), 65536u * 15u);
    EXPECT_LE(play.waves(), 60u);
}

/// A binary tree of depth 3 over 4 rays, in levels of 4 slots: a wave takes two rays at most, except from the last level.
TEST(Levels, EachStepIsToldToThoseWhoAsk) {
    std::vector<WaveStep> steps;
    Levels levels(test_device(), 4, {2, 2}, 3, {}, [&](const WaveStep &step) { steps.push_back(step); });
    levels.start(4);
    while (const auto wave = levels.next())
        if (wave->children) levels.add_children(*wave, 2 * wave->count);

    using Waiting = std::vector<uint>;
    const std::vector<std::tuple<uint, uint, Waiting>> expected = {{0, 2, {4}},       {1, 2, {2, 4}},    {2, 4, {2, 2, 4}}, {1, 2, {2, 2, 0}},
                                                                   {2, 4, {2, 0, 4}}, {0, 2, {2, 0, 0}}, {1, 2, {0, 4, 0}}, {2, 4, {0, 2, 4}},
                                                                   {1, 2, {0, 2, 0}}, {2, 4, {0, 0, 4}}, {0, 0, {0, 0, 0}}};
    ASSERT_EQ(steps.size(), expected.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        EXPECT_EQ(std::tuple(steps[i].generation, steps[i].count, steps[i].waiting), expected[i]) << "step " << i;
}

TEST(Levels, TheyCanBeStartedAgain) {
    const Case c{.batch = 64, .branching = {2, 2}, .generations = 3, .survival = Survival::half, .start = 64};
    Levels levels(test_device(), c.batch, c.branching, c.generations, {.interior_size = 1});
    for (uint count : {64u, 1u, 33u}) {
        levels.start(count);
        uint handed_out = 0;
        while (const auto wave = levels.next()) {
            if (wave->generation == 0) handed_out += wave->count;
            if (wave->children) levels.add_children(*wave, wave->count);
        }
        EXPECT_EQ(handed_out, count);
    }
}

}  // namespace
}  // namespace brandung
