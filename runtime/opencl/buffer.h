/// Buffer<T>: an array of records on a device.
#pragma once
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "runtime/opencl/device.h"

namespace brandung {

/// Bytes on their way from a device to where they were asked for, which must last until they have come.
class RawReading {
public:
    struct Implementation;
    explicit RawReading(std::unique_ptr<Implementation> implementation);  ///< null: nothing is to come
    RawReading(RawReading &&) noexcept;
    RawReading &operator=(RawReading &&) = delete;  // who owns the place would let go of it before
    /// Waits, if nobody has.
    ~RawReading();
    void wait();

private:
    std::unique_ptr<Implementation> implementation_;
};

/// Records on their way from a device.
template <class T> class Reading {
public:
    Reading(RawReading reading, std::unique_ptr<T[]> items, std::size_t count)
        : items_(std::move(items)), count_(count), reading_(std::move(reading)) {}
    /// Waits until they are there.
    std::span<const T> items() {
        reading_.wait();
        return {items_.get(), count_};
    }

private:
    std::unique_ptr<T[]> items_;
    std::size_t count_;
    RawReading reading_;  ///< goes first at the end
};

/// Bytes on a device.
class RawBuffer {
public:
    /// Throws Error, with the sizes, if the device cannot hold `bytes`. At least one byte is allocated: OpenCL knows no empty buffers.
    RawBuffer(Device &device, std::size_t bytes);
    RawBuffer(RawBuffer &&) noexcept;
    RawBuffer &operator=(RawBuffer &&) noexcept;
    ~RawBuffer();

    std::size_t bytes() const { return bytes_; }
    /// All of these come after everything launched before; read_bytes and write_bytes wait until they are done.
    void write_bytes(std::size_t offset, std::span<const std::byte> bytes);
    void read_bytes(std::size_t offset, std::span<std::byte> bytes) const;
    /// Returns at once.
    RawReading start_reading_bytes(std::size_t offset, std::span<std::byte> bytes) const;
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
    /// Of all as they are after what has been launched so far; the device goes on meanwhile.
    Reading<T> start_reading() const {
        auto items = std::make_unique<T[]>(size_);
        RawReading reading = start_reading_bytes(0, std::as_writable_bytes(std::span(items.get(), size_)));
        return {std::move(reading), std::move(items), size_};
    }

private:
    std::size_t size_;
};

}  // namespace brandung
