#include "tools/numbers.h"

#include <gtest/gtest.h>

namespace brandung {
namespace {

std::string fault(const CLI::Validator &validator, std::string text) { return validator(text); }

/// CLI11 would take a number that begins with 0 for an octal one.
TEST(Numbers, WholeOnesAreDecimalWithoutZerosBefore) {
    for (const char *text : {"1", "10", "16"}) EXPECT_EQ(fault(whole_numbers(1, 16), text), "") << text;
    for (const char *text : {"0", "17", "010", "1.5", "ten", "", "-1", "0x10"})
        EXPECT_EQ(fault(whole_numbers(1, 16), text), "must be a whole number from 1 to 16, got '" + std::string(text) + "'");
    EXPECT_EQ(fault(whole_numbers(0, 1), "0"), "");
}

}  // namespace
}  // namespace brandung
