/// Whether a device is known to fail the self-test: verdicts are kept in the user's cache folder, per device, driver, program and kernels.
#pragma once
#include <string>
#include <vector>

#include "runtime/selftest/selftest.h"

namespace brandung {

/// $XDG_CACHE_HOME/brandung/selftest.json, or ~/.cache/brandung/selftest.json; empty where the environment names no such place.
std::string verdicts_file();

struct Trust {
    Outcome outcome = Outcome::untried;
    std::string date;     ///< YYYY-MM-DD, of the oldest failure, or else pass, of a subject; empty where it is untried
    std::string why_not;  ///< names the subjects that failed, and their kernels; empty: none is known to have
    std::string warning;  ///< about the file
};
/// What is known of the device. A file that is not there says nothing; one that cannot be understood too, with a warning.
Trust known_trust(const DeviceInfo &device);

/// Adds these subjects' verdicts to those that are known of the device. A pass on fewer inputs than what is known rests on takes nothing back. Gives
/// a warning where that cannot be done, or the file could not be understood and is begun anew.
std::string remember(const DeviceInfo &device, const std::vector<SubjectReport> &reports);

}  // namespace brandung
