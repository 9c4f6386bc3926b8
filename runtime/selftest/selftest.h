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
};

struct SelfTestOptions {
    std::vector<std::string> only;  ///< names of subjects; none: all
    double seconds = 0;             ///< further rounds, with inputs of their own, until so much time has passed
    std::function<void(const std::string &subject, uint round)> on_round = [](const std::string &, uint) {};
    std::function<bool()> stop = [] { return false; };  ///< asked between rounds
};

/// In the order of the list.
std::vector<SubjectReport> run_selftest(Device &device, const SelfTestOptions &options);

}  // namespace brandung
