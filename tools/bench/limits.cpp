#include "tools/bench/limits.h"

#include <vector>

#include "runtime/opencl/kernel.h"
#include "runtime/opencl/seconds_now.h"
#include "tools/median.h"

namespace brandung {
namespace {

constexpr const char *file = "kernels/bench/limits.cl";
constexpr double flops_of_item = 2 * 8 * 64;  ///< CHAINS * CHAIN multiply-adds

/// Of nine launches, after one that compiles; what is measured begins when the device has nothing else to do.
template <class Launch> double median_seconds(Device &device, Launch launch) {
    std::vector<double> times;
    for (int i = 0; i < 10; ++i) {
        const double start = seconds_now();
        launch();
        device.finish();
        times.push_back(seconds_now() - start);
    }
    return median({times.begin() + 1, times.end()});
}

}  // namespace

Limits measure_limits(Device &device) {
    constexpr uint words = 1 << 24, floats = 1 << 18;
    Kernel copy(device, file, "copy", {}), multiply_add(device, file, "multiply_add", {});
    Buffer<uint> from(device, words), to(device, words);
    from.fill_zero(), to.fill_zero();
    Buffer<float> in(device, floats), out(device, floats);
    in.fill_zero();
    const double launch = median_seconds(device, [&] { copy(1, from, to, 1u); });
    const double copying = median_seconds(device, [&] { copy(words, from, to, words); });
    const double computing = median_seconds(device, [&] { multiply_add(floats, in, out, floats); });
    return {8.0 * words / (copying - launch), flops_of_item * floats / (computing - launch), launch};
}

}  // namespace brandung
