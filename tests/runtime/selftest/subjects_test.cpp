/// The self-test's subjects, one round of each: this is where the kernels' functions are tested for how right they are.
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/selftest/oracle.h"
#include "runtime/selftest/subject.h"
#include "tests/support/probe.h"

namespace brandung {

void PrintTo(const SubjectEntry &subject, std::ostream *out) { *out << subject.name; }

namespace {

class Subjects : public testing::TestWithParam<SubjectEntry> {};

bool is_of_primitives(const std::string &name) {
    const auto &oracles = primitive_oracles();
    return std::any_of(oracles.begin(), oracles.end(), [&](const PrimitiveOracle *oracle) { return oracle->kind().name == name; });
}

/// Most inputs must say something: they meet what they are aimed at, rounding cannot turn that, and what is measured has bounds; most of all
/// crossings, whose bounds on t must not be ten times what happens either.
TEST_P(Subjects, Pass) {
    Findings findings = GetParam().make(test_device())->examine(0);
    EXPECT_TRUE(findings.passed()) << findings.fault;
    EXPECT_GE(findings.inputs, 1u << 16);
    EXPECT_GT(findings.hits, findings.inputs * 2 / 5);
    EXPECT_LT(findings.ambiguous, findings.inputs / 3);
    for (const Errors &errors : findings.errors) EXPECT_LE(errors.unknown, (errors.count + errors.unknown) / 5);
    if (!is_of_primitives(GetParam().name)) return;
    EXPECT_LT(findings.ambiguous, findings.inputs / 4);
    EXPECT_GT(findings.of(Quantity::t).max_of_bound, 0.1);
}

INSTANTIATE_TEST_SUITE_P(All, Subjects, testing::ValuesIn(subjects()), [](const auto &info) { return info.param.name; });

TEST(PrimitiveOracles, EveryKindHasOne) { EXPECT_EQ(primitive_oracles().size(), primitive_kinds().size()); }

}  // namespace
}  // namespace brandung
