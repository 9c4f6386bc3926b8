/// Time and work per kernel.
#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace brandung {

struct KernelProfile {
    std::uint64_t launches = 0, items = 0;
    double milliseconds = 0;
};
/// Kernel name -> what its launches took so far.
using Profile = std::map<std::string, KernelProfile>;

}  // namespace brandung
