/// A scene's render, measured kernel by kernel over several runs.
#pragma once
#include <functional>
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
    uint runs_total;  ///< that were asked for

    bool interrupted() const { return seconds.size() < runs_total; }
};

/// Renders once to warm up and then `runs` times. `tell` is told which run begins, 0 being the first; `goes_on` is asked now and then, and ends all
/// by false: a run that it breaks does not count.
Measurements measure(Job &job, uint runs, const std::function<void(uint run)> &tell, const std::function<bool()> &goes_on);

}  // namespace brandung
