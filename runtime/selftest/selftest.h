/// The self-test: whether a device computes what the kernels say, against extended precision.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "runtime/selftest/subject.h"

namespace brandung {

/// What has come of one subject.
struct SubjectReport {
    const SubjectEntry *subject;
    Findings findings;
    uint rounds = 0;
    double seconds = 0;
    std::string fault;  ///< the first one, or why it could not be tried at all; empty: there is none
    bool passed() const { return fault.empty() && findings.passed(); }
    /// Whether it was tried on all inputs of a default run.
    bool complete() const { return rounds >= subject->rounds; }
};

/// What is known of a device. A failure is one after any inputs; it has passed after all subjects have, on all inputs of a default run.
enum class Outcome { untried, incomplete, passed, failed };
inline constexpr const char *outcome_names[] = {"untried", "incomplete", "passed", "failed"};

struct SelfTestOptions {
    std::vector<std::string> only;  ///< names of subjects; none: all
    double seconds = 0;             ///< further rounds, with inputs of their own, until so much time has passed
    std::function<void(const std::string &subject, uint round)> on_round = [](const std::string &, uint) {};
    std::function<bool()> stop = [] { return false; };  ///< asked between rounds
};

/// In the order of the list.
std::vector<SubjectReport> run_selftest(Device &device, const SelfTestOptions &options);

/// What these reports make known; those that were stopped, and those of a part of the subjects, never that it has passed.
Outcome outcome_of(const std::vector<SubjectReport> &reports, bool interrupted);

}  // namespace brandung
