/// Accelerators compared on the rays of a scene's own render.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "runtime/accelerators/ray_tracing.h"
#include "tools/job.h"

namespace brandung {

constexpr std::size_t ray_uses = 4;
constexpr std::array<const char *, ray_uses> names_of_uses = {"camera", "secondary", "shadow", "random"};  ///< by RayQueue::Use

/// What one accelerator does for the rays of one use.
struct UseOfRays {
    WorkSums work;
    std::uint64_t different = 0;  ///< answers that are not those of others
    std::vector<double> seconds;  ///< that the device took for all these rays, by round
};

struct AcceleratorRow {
    std::string scene, accelerator;
    bool packets = false;
    std::size_t primitives = 0, instances = 0, node_bytes = 0, block_bytes = 0;
    double build_seconds = 0;
    std::array<UseOfRays, ray_uses> uses{};  ///< by RayQueue::Use
    std::uint64_t different() const;
};

struct AcceleratorTrial {
    std::vector<std::string> accelerators;  ///< names
    uint runs = 5;
    uint batch = default_batch;
    std::size_t most_rays = SIZE_MAX;  ///< of each use
    std::size_t random_rays = 0;       ///< that are traced beside the render's
    bool check = false;                ///< whether every ray goes through `none` too
    std::function<void(const std::string &what)> tell;
    std::function<bool()> goes_on;  ///< false ends it: rows have what was measured until then
};

/// Rows in the order of the names. Answers of the stages of renders are compared with those of the kernels that count, and with those of `none` if
/// asked.
std::vector<AcceleratorRow> try_accelerators(Job &job, const AcceleratorTrial &trial);

}  // namespace brandung
