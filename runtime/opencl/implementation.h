/// What a Device is made of; for this folder only.
#pragma once
#include <CL/opencl.hpp>

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "runtime/opencl/access.h"
#include "runtime/opencl/seconds_now.h"

namespace brandung {

/// Of a kernel, or without a name of something else that the device does in between.
struct PendingLaunch {
    std::string kernel;
    std::uint64_t items, rows;
    Traffic traffic;
    cl::Event event;
    double enqueued = seconds_now();
};

struct Device::Implementation {
    DeviceInfo info;
    cl::Device device;
    cl::Context context;
    cl::CommandQueue queue;
    std::map<std::string, cl::Program> programs;  ///< expanded text -> program
    std::set<std::string> kernels;                ///< names of those made so far
    std::vector<PendingLaunch> pending;
    cl_ulong busy_until = 0;  ///< by the device's clock [ns]: when the last one known to be done had ended
    Profile profile;
    double build_seconds = 0;
    std::function<void(const std::string &)> on_build;
    std::function<void(const Build &)> on_built;
    std::function<void(const Launch &)> on_launch;
    std::optional<double> clock_offset;  ///< from the device's clock to the host's [s]
};

/// Calls OpenCL; an exception of the bindings becomes an Error that says what was attempted.
template <class Call> auto attempt(const std::string &what, Call call) {
    try {
        return call();
    } catch (const cl::Error &error) {
        throw Error(what + ": " + error.what() + " failed with " + status_name(error.err()));
    }
}

/// The program of a kernel file with its includes expanded, built on first use.
cl::Program &program_for(Device::Implementation &device, const std::string &file, const std::string &text);

}  // namespace brandung
