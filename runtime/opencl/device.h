/// Device: one OpenCL device with its context, queue, programs and profile. No other folder sees OpenCL's own types.
#pragma once
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "kernels/core/portable.h"
#include "runtime/opencl/error.h"
#include "runtime/opencl/profiler.h"

namespace brandung {

struct DeviceInfo {
    std::string platform, name, version, driver;
    std::string unsuitable;  ///< why it cannot be used, or empty
    bool cpu = false;        ///< has kernels as CPUs need them
    bool doubles = false;    ///< has cl_khr_fp64, which only the self-test uses
    uint compute_units = 0;
    std::uint64_t memory = 0, largest_allocation = 0;  ///< [bytes]
};

class Device {
public:
    /// The first suitable device whose platform or name contains `name` (any case), CPUs first. `threads` limits the compute units of a CPU,
    /// 0 takes all. Throws Error if there is none, naming those that were looked at. With `as_gpu` a CPU has what a GPU would have: the kernels, one
    /// item per work-item, and the groups, so that these can be tested without a GPU.
    static Device select(const std::string &name = "", uint threads = 0, bool as_gpu = false);
    /// All devices of all platforms; the flag says which one select("") takes.
    static std::vector<std::pair<DeviceInfo, bool>> list();

    Device(Device &&) noexcept;
    ~Device();

    const DeviceInfo &info() const;
    /// Items that one work-item of a stage handles: a chunk on a CPU, one on a GPU.
    uint items_per_work_item() const;
    /// Waits until everything launched has been done, and adds its times to the profile.
    void finish();
    const Profile &profile() const;
    /// Names of the kernels made so far, sorted.
    const std::set<std::string> &kernels() const;
    /// Seconds spent so far in building programs.
    double build_seconds() const;
    /// Called with a kernel file's name before it is built.
    void on_build(std::function<void(const std::string &)> callback);
    /// Called after builds, and with launches that have been done, in their order, whenever work is waited for.
    void on_built(std::function<void(const Build &)> callback);
    void on_launch(std::function<void(const Launch &)> callback);

    struct Implementation;
    Implementation &implementation() { return *implementation_; }

private:
    explicit Device(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace brandung
