#include "runtime/opencl/device.h"

#include <algorithm>
#include <cctype>

#include "runtime/opencl/implementation.h"
#include "runtime/opencl/kernel_cache.h"

namespace brandung {
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

std::string why_unsuitable(const cl::Device &device) {
    const std::string extensions = device.getInfo<CL_DEVICE_EXTENSIONS>();
    if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return "is not available";
    if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "has no compiler";
    if (extensions.find("cl_khr_int64_base_atomics") == std::string::npos) return "lacks cl_khr_int64_base_atomics";
    const cl_device_fp_config floats = device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
    if (!(floats & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT)) return "does not round divisions correctly";
    if (!(floats & CL_FP_DENORM)) return "has no subnormal numbers";
    if (!(floats & CL_FP_FMA)) return "has no fused multiply-add";
    return "";
}

void describe(const cl::Device &device, DeviceInfo &info) {
    info.name = device.getInfo<CL_DEVICE_NAME>();
    info.platform = cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>();
    info.version = device.getInfo<CL_DEVICE_VERSION>();
    info.driver = device.getInfo<CL_DRIVER_VERSION>();
    info.unsuitable = why_unsuitable(device);
    info.doubles = device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_khr_fp64") != std::string::npos;
    info.cpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
    info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    info.memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    info.largest_allocation = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
}

struct Candidate {
    DeviceInfo info;
    cl::Device device;
};

/// A driver that fails at its own device's description must not keep the other devices from being used.
Candidate candidate(const cl::Device &device) {
    Candidate result{{}, device};
    try {
        describe(device, result.info);
    } catch (const cl::Error &error) {
        if (result.info.name.empty()) result.info.name = "device without a name";
        result.info.unsuitable = std::string("cannot be described: ") + error.what() + " failed with " + status_name(error.err());
    }
    return result;
}

/// CPUs first, otherwise in the platforms' order.
std::vector<Candidate> candidates() {
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error &) {
        return {};  // the loader reports an error where no platform is installed
    }
    std::vector<Candidate> found;
    for (const cl::Platform &platform : platforms) {
        std::vector<cl::Device> devices;
        try {
            platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
        } catch (const cl::Error &) {
            continue;  // a platform without devices
        }
        for (const cl::Device &device : devices) found.push_back(candidate(device));
    }
    std::stable_sort(found.begin(), found.end(), [](const Candidate &a, const Candidate &b) { return a.info.cpu > b.info.cpu; });
    return found;
}

bool matches(const Candidate &candidate, const std::string &name) {
    return lower(candidate.info.platform + " " + candidate.info.name).find(lower(name)) != std::string::npos;
}

cl::Device limited(const cl::Device &device, uint threads) {
    if (threads == 0 || threads >= device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>()) return device;
    const cl_device_partition_property properties[] = {CL_DEVICE_PARTITION_BY_COUNTS, static_cast<cl_device_partition_property>(threads),
                                                       CL_DEVICE_PARTITION_BY_COUNTS_LIST_END, 0};
    std::vector<cl::Device> parts;
    cl::Device whole = device;
    whole.createSubDevices(properties, &parts);
    return parts.at(0);
}

/// PoCL has no device where it cannot write its cache.
std::string no_device() {
    const std::string fault = kernel_cache_fault();
    return "no OpenCL device found: " + (fault.empty() ? "install one, for a CPU Debian's package pocl-opencl-icd" : fault);
}

std::string nothing_found(const std::string &name, const std::vector<Candidate> &all) {
    if (all.empty()) return no_device();
    std::string text = name.empty() ? "no suitable OpenCL device" : "no suitable OpenCL device matches '" + name + "'";
    for (const Candidate &candidate : all)
        text += "; '" + candidate.info.name + "' " + (candidate.info.unsuitable.empty() ? "does not match" : candidate.info.unsuitable);
    return text;
}

/// The clocks of host and device agree at the moment at which the first launch was enqueued.
void tell_launch(Device::Implementation &device, const PendingLaunch &launch, cl_ulong start, cl_ulong end) {
    if (!device.clock_offset)
        device.clock_offset = launch.enqueued - static_cast<double>(launch.event.getProfilingInfo<CL_PROFILING_COMMAND_QUEUED>()) * 1e-9;
    const auto on_host = [&](cl_ulong nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9 + *device.clock_offset; };
    device.on_launch({launch.kernel, launch.items, launch.enqueued, on_host(start), on_host(end)});
}

/// `possible`: when it could have begun. All times are of the device's clock [ns].
void add_launch(const PendingLaunch &launch, cl_ulong possible, cl_ulong start, cl_ulong end, KernelProfile &profile) {
    const double items = static_cast<double>(launch.items);
    profile.launches += 1;
    profile.items += launch.items;
    profile.milliseconds += static_cast<double>(end - start) * 1e-6;
    profile.waiting_milliseconds += static_cast<double>(start - std::min(start, possible)) * 1e-6;
    profile.bytes = profile.bytes && launch.traffic.item_bytes ? std::optional(*profile.bytes + items * *launch.traffic.item_bytes) : std::nullopt;
    profile.capacity += launch.traffic.capacity * static_cast<double>(launch.rows);
}

}  // namespace

Device Device::select(const std::string &name, uint threads, bool as_gpu) {
    const std::vector<Candidate> all = candidates();
    const auto chosen = std::find_if(all.begin(), all.end(),
                                     [&](const Candidate &candidate) { return candidate.info.unsuitable.empty() && matches(candidate, name); });
    if (chosen == all.end()) throw Error(nothing_found(name, all));
    return attempt("device '" + chosen->info.name + "'", [&] {
        auto implementation = std::make_unique<Implementation>();
        implementation->device = limited(chosen->device, chosen->info.cpu ? threads : 0);
        describe(implementation->device, implementation->info);
        implementation->info.cpu &= !as_gpu;
        implementation->context = cl::Context(implementation->device);
        implementation->queue = cl::CommandQueue(implementation->context, implementation->device, CL_QUEUE_PROFILING_ENABLE);
        return Device(std::move(implementation));
    });
}

std::vector<std::pair<DeviceInfo, bool>> Device::list() {
    std::vector<std::pair<DeviceInfo, bool>> devices;
    bool chosen = false;
    for (const Candidate &candidate : candidates()) {
        const bool this_one = !chosen && candidate.info.unsuitable.empty();
        devices.emplace_back(candidate.info, this_one);
        chosen |= this_one;
    }
    return devices;
}

Device::Device(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
Device::Device(Device &&) noexcept = default;
Device::~Device() = default;

const DeviceInfo &Device::info() const { return implementation_->info; }
uint Device::items_per_work_item() const { return implementation_->info.cpu ? ITEMS_PER_CHUNK : 1; }
const Profile &Device::profile() const { return implementation_->profile; }
const std::set<std::string> &Device::kernels() const { return implementation_->kernels; }
double Device::build_seconds() const { return implementation_->build_seconds; }
void Device::on_build(std::function<void(const std::string &)> callback) { implementation_->on_build = std::move(callback); }

void Device::on_built(std::function<void(const Build &)> callback) { implementation_->on_built = std::move(callback); }
void Device::on_launch(std::function<void(const Launch &)> callback) { implementation_->on_launch = std::move(callback); }

void Device::finish() {
    attempt("finishing the device's work", [&] { implementation_->queue.finish(); });
    for (const PendingLaunch &launch : implementation_->pending) {
        const auto start = launch.event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
        const auto end = launch.event.getProfilingInfo<CL_PROFILING_COMMAND_END>();
        const auto possible = std::max(implementation_->busy_until, launch.event.getProfilingInfo<CL_PROFILING_COMMAND_QUEUED>());
        implementation_->busy_until = end;
        if (launch.kernel.empty()) continue;
        add_launch(launch, possible, start, end, implementation_->profile[launch.kernel]);
        if (implementation_->on_launch) tell_launch(*implementation_, launch, start, end);
    }
    implementation_->pending.clear();
}

}  // namespace brandung
