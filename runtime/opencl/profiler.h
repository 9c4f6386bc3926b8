/// Time and work per kernel.
#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace brandung {

struct KernelProfile {
    std::uint64_t launches = 0, items = 0;
    double milliseconds = 0;
    std::uint64_t bytes = 0;  ///< of records in arrays that have one for every item, once per item
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
