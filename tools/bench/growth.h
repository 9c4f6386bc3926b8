/// How the work of rays grows with the number of objects, by accelerator.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "runtime/accelerators/ray_tracing.h"
#include "runtime/wavefront/batch.h"

namespace brandung {

/// Of one accelerator of one scene; the two kinds of rays are those of rays_in_cube().
struct GrowthRow {
    std::string scene, accelerator;
    uint objects = 0;
    double build_seconds = 0;
    std::size_t bytes = 0;  ///< of nodes and blocks
    std::size_t rays = 0;   ///< of each kind
    struct Kind {
        WorkSums work;
        std::vector<double> seconds;  ///< that the device took for them, by round
    } closest, any;
};

struct GrowthTrial {
    std::vector<std::string> scenes, accelerators;  ///< names
    std::vector<uint> objects;
    std::size_t rays = 65536;
    uint runs = 3;
    uint batch = default_batch;
    std::function<void(const std::string &what)> tell;
    std::function<bool()> goes_on;  ///< false ends it
};

struct Growth {
    std::vector<GrowthRow> rows;     ///< all of whose rays were counted, and traced at least once
    std::vector<std::string> notes;  ///< what was left out, and why
};

/// By scenes, numbers of objects (ascending) and accelerators, in the order of the lists. What took longer than longest_build is not built of more
/// objects; `none` gets only most_pairs / objects rays.
Growth measure_growth(Device &device, const GrowthTrial &trial);
inline constexpr double longest_build = 20;            ///< [s]
inline constexpr std::size_t most_pairs = 1ull << 31;  ///< of a ray and an object

}  // namespace brandung
