/// kernels/stages/compact.cl, as runtime/wavefront/compaction.h runs it: stable lists of what is alive.
#include <gtest/gtest.h>

#include "runtime/wavefront/compaction.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

using Alive = std::vector<std::uint8_t>;

constexpr uint untouched = 0xdeadbeef;

struct Lists {
    std::vector<uint> list, counts;
};

Lists compact(const Alive &alive, uint stride, uint count, uint rows, uint base, uint list_first) {
    Device &device = test_device();
    Compaction compaction(device, stride, rows);
    const Buffer<std::uint8_t> slots(device, alive);
    Buffer<uint> list(device, std::vector<uint>(std::size_t{stride} * rows + list_first, untouched));
    compaction(slots, stride, count, rows, base, list_first, list);
    return {list.read(), compaction.counts().read()};
}

Lists expected(const Alive &alive, uint stride, uint count, uint rows, uint base, uint list_first) {
    Lists lists{std::vector<uint>(std::size_t{stride} * rows + list_first, untouched), std::vector<uint>(rows, 0)};
    for (uint row = 0; row < rows; ++row)
        for (uint slot = row * stride; slot < row * stride + count; ++slot)
            if (alive[slot]) lists.list[row * stride + list_first + lists.counts[row]++] = base + slot;
    return lists;
}

void expect_right(const Alive &alive, uint stride, uint count, uint rows, uint base, uint list_first) {
    const Lists found = compact(alive, stride, count, rows, base, list_first), right = expected(alive, stride, count, rows, base, list_first);
    EXPECT_EQ(found.counts, right.counts) << count << " slots";
    EXPECT_TRUE(found.list == right.list) << count << " slots: the list is wrong, or something was written beside it";
}

/// Around the sizes of chunks (256) and of a stage's work-items (64).
const uint counts[] = {1, 2, 63, 64, 65, 127, 128, 129, 255, 256, 257, 511, 512, 513, 1000, 65535, 65536, 65537, 300'001};

void for_each_count(auto make) {
    for (const uint count : counts) expect_right(make(count), count, count, 1, 0, 0);
}

TEST(Compact, NoneAlive) {
    for_each_count([](uint count) { return Alive(count, 0); });
}

TEST(Compact, AllAlive) {
    for_each_count([](uint count) { return Alive(count, 1); });
}

TEST(Compact, OneAliveFirstLastOrInTheMiddle) {
    for (const uint place : {0u, 1u, 2u})
        for_each_count([place](uint count) {
            Alive alive(count, 0);
            alive[place == 0 ? 0 : place == 1 ? count - 1 : count / 2] = 1;
            return alive;
        });
}

TEST(Compact, EveryOtherAlive) {
    for (const uint first : {0u, 1u})
        for_each_count([first](uint count) {
            Alive alive(count, 0);
            for (uint i = first; i < count; i += 2) alive[i] = 1;
            return alive;
        });
}

TEST(Compact, RandomOnesAliveFromFewToMost) {
    for (const float share : {0.01f, 0.5f, 0.99f})
        for_each_count([share](uint count) {
            Random random(count);
            Alive alive(count, 0);
            for (std::uint8_t &one : alive) one = random.uniform(0, 1) < share;
            return alive;
        });
}

TEST(Compact, RowsAreIndependentAndWhatLiesBetweenThemIsNeitherReadNorWritten) {
    for (const uint count : {1u, 64u, 255u, 256u, 257u, 1000u}) {
        const uint stride = count + 16, rows = 8;
        Random random(count);
        Alive alive(stride * rows, 1);  // beyond `count` too, where nobody may look
        for (uint row = 0; row < rows; ++row)
            for (uint i = 0; i < count; ++i) alive[row * stride + i] = row == 0 ? 0 : row == 1 ? 1 : random.below(2);
        expect_right(alive, stride, count, rows, 0, 0);
    }
}

TEST(Compact, ListsAreAppendedToAndSlotsCountFromBase) {
    Alive alive(777);
    Random random(1);
    for (std::uint8_t &one : alive) one = random.below(2);
    expect_right(alive, 777, 777, 1, 5000, 123);
    expect_right(alive, 777, 300, 1, 5000, 123);
}

TEST(Compact, NoSlotsGiveNoEntries) {
    Alive alive(100, 1);
    const Lists found = compact(alive, 100, 0, 1, 0, 0);
    EXPECT_EQ(found.counts, std::vector<uint>{0});
    EXPECT_EQ(found.list, std::vector<uint>(100, untouched));
}

TEST(Compact, ARowIsCompactedAgainWithFewerSlots) {
    Device &device = test_device();
    Compaction compaction(device, 1000, 1);
    const Buffer<std::uint8_t> slots(device, Alive(1000, 1));
    Buffer<uint> list(device, 1000);
    compaction(slots, 1000, 1000, 1, 0, 0, list);
    compaction(slots, 1000, 10, 1, 0, 0, list);
    EXPECT_EQ(compaction.counts().read(), std::vector<uint>{10});
}

}  // namespace
}  // namespace brandung
