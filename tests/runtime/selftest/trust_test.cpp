/// What is known of a device after self-tests: what counts as a pass of the whole, and what takes a failure back.
#include "runtime/selftest/trust.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace brandung {
namespace {

const DeviceInfo device = {.platform = "a platform", .name = "a device", .version = "", .driver = "1", .unsuitable = ""};

SubjectReport report(const SubjectEntry &subject, uint rounds, const std::string &fault = "") {
    return {.subject = &subject, .findings = {}, .rounds = rounds, .seconds = 0, .fault = fault};
}

std::vector<SubjectReport> default_run() {
    std::vector<SubjectReport> reports;
    for (const SubjectEntry &subject : subjects()) reports.push_back(report(subject, subject.rounds));
    return reports;
}

/// A cache folder of its own.
class Trusting : public testing::Test {
protected:
    Trusting() { setenv("XDG_CACHE_HOME", folder.c_str(), 1); }
    ~Trusting() override { unsetenv("XDG_CACHE_HOME"), std::filesystem::remove_all(folder); }
    void remember(const std::vector<SubjectReport> &reports) { EXPECT_EQ(brandung::remember(device, reports), ""); }

    const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("trust_test." + std::to_string(getpid()));
    const SubjectEntry &first = subjects().front(), &last = subjects().back();
};

TEST_F(Trusting, OnlyAllSubjectsOnAllInputsOfADefaultRunAreAPass) {
    EXPECT_EQ(known_trust(device).outcome, Outcome::untried);
    std::vector<SubjectReport> reports = default_run();
    reports.pop_back();
    remember(reports);
    EXPECT_EQ(known_trust(device).outcome, Outcome::incomplete);
    EXPECT_EQ(outcome_of(reports, false), Outcome::incomplete);
    remember({report(last, last.rounds)});
    EXPECT_EQ(known_trust(device).outcome, Outcome::passed) << "the parts have come together";
    EXPECT_EQ(known_trust(device).date.size(), 10u);
    DeviceInfo other = device;
    other.driver = "2";
    EXPECT_EQ(known_trust(other).outcome, Outcome::untried);
}

TEST_F(Trusting, AnInterruptedRunIsNoPass) {
    std::vector<SubjectReport> reports = default_run();
    EXPECT_EQ(outcome_of(reports, false), Outcome::passed);
    EXPECT_EQ(outcome_of(reports, true), Outcome::incomplete);
    const auto textures = std::find_if(reports.begin(), reports.end(), [](const SubjectReport &report) { return report.subject->rounds > 1; });
    textures->rounds = 1;
    EXPECT_EQ(outcome_of(reports, false), Outcome::incomplete);
    remember(reports);
    EXPECT_EQ(known_trust(device).outcome, Outcome::incomplete) << "a subject lacks a round";
    textures->rounds = 0, reports.back().rounds = 0;
    remember(reports);
    EXPECT_EQ(known_trust(device).outcome, Outcome::incomplete);
}

TEST_F(Trusting, AFailureStaysUntilAsManyInputsPass) {
    remember({report(first, 7, "wrong")});
    remember(default_run());
    EXPECT_EQ(known_trust(device).outcome, Outcome::failed) << "found by a longer run";
    EXPECT_NE(known_trust(device).why_not.find(first.name), std::string::npos);
    remember({report(first, 1, "wrong")});
    remember({report(first, 6)});
    EXPECT_EQ(known_trust(device).outcome, Outcome::failed) << "the longer run's failure is not forgotten for a short one's";
    remember({report(first, 7)});
    EXPECT_EQ(known_trust(device).outcome, Outcome::passed);
}

TEST_F(Trusting, AShorterPassTakesNothingFromALongerOne) {
    remember(default_run());
    remember({report(first, first.rounds + 5)});
    SubjectReport short_run = report(last, 0);
    remember({report(first, 1), short_run});
    EXPECT_EQ(known_trust(device).outcome, Outcome::passed);
    remember({report(first, 0, "does not build")});
    EXPECT_EQ(known_trust(device).outcome, Outcome::failed);
}

}  // namespace
}  // namespace brandung
