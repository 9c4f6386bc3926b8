/// runtime/selftest/extended.h: digits beyond those of long double.
#include "runtime/selftest/extended.h"

#include <gtest/gtest.h>

namespace brandung {
namespace {

/// root² - 2 = 2 root times the root's error, which is at most half an ulp of it: 2^-113 of 113 bits, 2^-64 of long double's 64.
TEST(Extended, TheSquareRootHasTheDigitsOfItsType) {
    const extended root = square_root(extended(2));
    const bool has_113_bits = extended(1) + extended(0x1p-112) != 1;
    EXPECT_LE(double(absolute(root * root - 2)), has_113_bits ? 0x1p-110 : 0x1p-61);
    EXPECT_EQ(double(square_root(extended(9))), 3);
    EXPECT_EQ(double(square_root(extended(0))), 0);
    EXPECT_EQ(double(square_root(extended(-1))), 0);
    const extended tiny = extended(0x1p-1000) * extended(0x1p-1000);
    EXPECT_EQ(double(square_root(tiny) / extended(0x1p-1000)), 1);
}

TEST(Extended, UlpsAreThoseOfFloats) {
    EXPECT_EQ(ulp_of(1), 0x1p-23);
    EXPECT_EQ(ulp_of(-1.5), 0x1p-23);
    EXPECT_EQ(ulp_of(extended(0x1p-126)), 0x1p-149);
    EXPECT_EQ(ulp_of(0), 0x1p-149);
    EXPECT_EQ(ulp_of(extended(0x1p127)), 0x1p104);
}

}  // namespace
}  // namespace brandung
