/// Time and work per kernel.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace brandung {

struct KernelProfile {
    std::uint64_t launches = 0, items = 0;
    double milliseconds = 0;          ///< that the device ran it
    double waiting_milliseconds = 0;  ///< from when the device could have begun, since it was told to and had nothing else to do, until it did
    std::optional<double> bytes = 0;  ///< that its items read and wrote in arrays of records; nothing where that depends on what these say
    double capacity = 0;              ///< items that all its launches would have had, had its queues been full; 0 if it works on no queue
};
/// One launch that has been done. Times are seconds of the host's steady clock.
struct Launch {
    const std::string &kernel;
    std::uint64_t items;
    double enqueued, start, end;
};
/// The building of a kernel file, likewise.
struct Build {
    const std::string &file;
    double start, end;
};

/// Kernel name -> what its launches took so far.
using Profile = std::map<std::string, KernelProfile>;

}  // namespace brandung
