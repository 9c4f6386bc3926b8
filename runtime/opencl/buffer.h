/// Buffer<T>: an array of records on a device.
#pragma once
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "runtime/opencl/device.h"

namespace brandung {

/// Bytes on a device.
class RawBuffer {
public:
    /// Throws Error, with the sizes, if the device cannot hold `bytes`. At least one byte is allocated: OpenCL knows no empty buffers.
    RawBuffer(Device &device, std::size_t bytes);
    RawBuffer(RawBuffer &&) noexcept;
    RawBuffer &operator=(RawBuffer &&) noexcept;
    ~RawBuffer();

    std::size_t bytes() const { return bytes_; }
    /// All of these come after everything launched before; reading and writing wait until they are done.
    void write_bytes(std::size_t offset, std::span<const std::byte> bytes);
    void read_bytes(std::size_t offset, std::span<std::byte> bytes) const;
    void fill_zero();

    struct Implementation;
    const Implementation &implementation() const { return *implementation_; }

private:
    Device *device_;
    std::size_t bytes_;
    std::unique_ptr<Implementation> implementation_;
};

/// `size` records of T.
template <class T> class Buffer : public RawBuffer {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Buffer(Device &device, std::size_t size) : RawBuffer(device, size * sizeof(T)), size_(size) {}
    Buffer(Device &device, std::span<const T> items) : Buffer(device, items.size()) { write(items); }

    std::size_t size() const { return size_; }
    void write(std::span<const T> items, std::size_t first = 0) { write_bytes(first * sizeof(T), std::as_bytes(items)); }
    std::vector<T> read(std::size_t first, std::size_t count) const {
        std::vector<T> items(count);
        read_bytes(first * sizeof(T), std::as_writable_bytes(std::span(items)));
        return items;
    }
    std::vector<T> read() const { return read(0, size_); }

private:
    std::size_t size_;
};

}  // namespace brandung
