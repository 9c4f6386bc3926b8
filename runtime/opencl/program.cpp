#include "runtime/opencl/implementation.h"
#include "runtime/opencl/kernel_cache.h"

namespace brandung {
namespace {

constexpr const char *pocl = "Portable Computing Language";

std::string build_options(const DeviceInfo &info) {
    return std::string("-cl-std=CL1.2 -Werror -cl-fp32-correctly-rounded-divide-sqrt") + (info.cpu ? " -D CPU" : "");
}

}  // namespace

cl::Program &program_for(Device::Implementation &device, const std::string &file, const std::string &text) {
    if (const auto known = device.programs.find(text); known != device.programs.end()) return known->second;
    if (device.on_build) device.on_build(file);
    const double start = seconds_now();
    cl::Program program = attempt("program " + file, [&] { return cl::Program(device.context, text); });
    try {
        program.build(device.device, build_options(device.info).c_str());
    } catch (const cl::Error &error) {
        if (const std::string fault = device.info.platform == pocl ? kernel_cache_fault() : ""; !fault.empty())
            throw Error("kernel file " + file + " cannot be built on '" + device.info.name + "': " + fault);
        const std::string log = program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.device);
        throw BuildError("kernel file " + file + " does not build on '" + device.info.name + "': " + status_name(error.err()) + "\n" + log, log);
    }
    const double end = seconds_now();
    device.build_seconds += end - start;
    if (device.on_built) device.on_built({file, start, end});
    return device.programs.emplace(text, std::move(program)).first->second;
}

}  // namespace brandung
