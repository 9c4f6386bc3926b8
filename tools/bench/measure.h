/// A scene's render, measured kernel by kernel over several runs.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "tools/bench/limits.h"
#include "tools/job.h"

namespace brandung {

/// Of one render, as in KernelProfile; the milliseconds of every run, in their order.
struct KernelRuns {
    std::uint64_t launches = 0, items = 0;
    std::optional<double> bytes;
    double capacity = 0;
    std::vector<double> milliseconds, waiting_milliseconds;
};

struct Measurements {
    std::map<std::string, KernelRuns> kernels;
    std::vector<double> seconds;  ///< of whole renders
    RayCounts rays;               ///< of one render
    Limits limits;
};

/// Renders once to warm up and then `runs` times; `tell` is told which run begins, 0 being the first, and stops all by false.
Measurements measure(Job &job, uint runs, const std::function<bool(uint run)> &tell);

double median(std::vector<double> values);

}  // namespace brandung
