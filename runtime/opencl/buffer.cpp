#include "runtime/opencl/buffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/opencl/buffer_implementation.h"

namespace brandung {

struct RawReading::Implementation {
    cl::Event event;
};

RawBuffer::RawBuffer(Device &device, std::size_t bytes) : device_(&device), bytes_(bytes) {
    if (bytes > device.info().largest_allocation)
        throw Error(fmt::format("{:.1f} MiB do not fit in one allocation of '{}', which takes {:.1f} MiB at most",
                                static_cast<double>(bytes) / (1 << 20), device.info().name,
                                static_cast<double>(device.info().largest_allocation) / (1 << 20)));
    implementation_ = attempt("allocating " + std::to_string(bytes) + " bytes", [&] {
        return std::make_unique<Implementation>(
            Implementation{cl::Buffer(device.implementation().context, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, 1))});
    });
}
RawBuffer::RawBuffer(RawBuffer &&) noexcept = default;
RawBuffer &RawBuffer::operator=(RawBuffer &&) noexcept = default;
RawBuffer::~RawBuffer() = default;

void RawBuffer::write_bytes(std::size_t offset, std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    attempt("writing a buffer",
            [&] { device_->implementation().queue.enqueueWriteBuffer(implementation_->memory, CL_TRUE, offset, bytes.size(), bytes.data()); });
}

void RawBuffer::read_bytes(std::size_t offset, std::span<std::byte> bytes) const {
    if (bytes.empty()) return;
    attempt("reading a buffer",
            [&] { device_->implementation().queue.enqueueReadBuffer(implementation_->memory, CL_TRUE, offset, bytes.size(), bytes.data()); });
}

RawReading RawBuffer::start_reading_bytes(std::size_t offset, std::span<std::byte> bytes) const {
    if (bytes.empty()) return RawReading(nullptr);
    auto reading = std::make_unique<RawReading::Implementation>();
    attempt("reading a buffer", [&] {
        cl::CommandQueue &queue = device_->implementation().queue;
        queue.enqueueReadBuffer(implementation_->memory, CL_FALSE, offset, bytes.size(), bytes.data(), nullptr, &reading->event);
        queue.flush();
    });
    return RawReading(std::move(reading));
}

RawReading::RawReading(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
RawReading::RawReading(RawReading &&) noexcept = default;
RawReading::~RawReading() {
    if (!implementation_) return;
    const cl_event event = implementation_->event();
    clWaitForEvents(1, &event);  // a failure is told by what comes next
}

void RawReading::wait() {
    if (implementation_) attempt("reading a buffer", [&] { implementation_->event.wait(); });
    implementation_.reset();
}

void RawBuffer::fill_zero() {
    if (bytes_ == 0) return;
    PendingLaunch filling{.kernel = "", .items = 0, .rows = 0, .traffic = {}, .event = {}};
    attempt("clearing a buffer",
            [&] { device_->implementation().queue.enqueueFillBuffer(implementation_->memory, cl_uchar{0}, 0, bytes_, nullptr, &filling.event); });
    device_->implementation().pending.push_back(std::move(filling));
}

}  // namespace brandung
