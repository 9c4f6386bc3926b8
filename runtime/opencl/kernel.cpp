#include "runtime/opencl/kernel.h"

#include "runtime/opencl/buffer_implementation.h"

namespace brandung {

struct Kernel::Implementation {
    cl::Kernel kernel;
    uint parameters;
};

Kernel::Kernel(Device &device, const std::string &file, const std::string &name, const Sources &generated, uint items_per_work_item)
    : device_(&device), name_(name), items_per_work_item_(items_per_work_item ? items_per_work_item : device.items_per_work_item()) {
    cl::Program &program = program_for(device.implementation(), file, expand_source(file, generated));
    implementation_ = attempt("kernel " + name + " of " + file, [&] {
        cl::Kernel kernel(program, name.c_str());
        const uint parameters = kernel.getInfo<CL_KERNEL_NUM_ARGS>();
        return std::make_unique<Implementation>(Implementation{std::move(kernel), parameters});
    });
    device.implementation().kernels.insert(name);
}
Kernel::Kernel(Kernel &&) noexcept = default;
Kernel::~Kernel() = default;

void Kernel::set_buffer(uint index, const RawBuffer &buffer) {
    attempt("argument " + std::to_string(index) + " of " + name_, [&] { implementation_->kernel.setArg(index, buffer.implementation().memory); });
}

void Kernel::set_value(uint index, const void *value, std::size_t bytes) {
    attempt("argument " + std::to_string(index) + " of " + name_, [&] { implementation_->kernel.setArg(index, bytes, value); });
}

namespace {

/// One work-item a group on CPUs: private arrays cost their size times the group's, and chunks make groups big enough.
std::size_t group_size(const DeviceInfo &info) { return info.cpu ? 1 : 64; }

}  // namespace

std::size_t Kernel::work_items(std::size_t items) const {
    const std::size_t group = group_size(device_->info()), needed = (items + items_per_work_item_ - 1) / items_per_work_item_;
    return (needed + group - 1) / group * group;
}

void Kernel::launch(Grid grid, uint arguments) {
    if (arguments != implementation_->parameters)
        throw Error("kernel " + name_ + " takes " + std::to_string(implementation_->parameters) + " arguments, got " + std::to_string(arguments));
    PendingLaunch launch{.kernel = name_, .items = grid.items * grid.rows, .rows = grid.rows, .traffic = traffic_, .event = {}};
    attempt("launching " + name_, [&] {
        device_->implementation().queue.enqueueNDRangeKernel(implementation_->kernel, cl::NullRange, cl::NDRange(work_items(grid.items), grid.rows),
                                                             cl::NDRange(group_size(device_->info()), 1), nullptr, &launch.event);
    });
    device_->implementation().pending.push_back(std::move(launch));
}

}  // namespace brandung
