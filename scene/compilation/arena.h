/// Arena: what kernels read of a scene, one array of records after another.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "kernels/core/scene.h"

namespace brandung {

/// Kernels read record 0 of an array where they have none to read.
inline constexpr std::size_t largest_record = 448;

/// Grows in records, each array at a multiple of 64 bytes.
class Arena {
public:
    explicit Arena(std::vector<std::byte> &bytes) : bytes_(bytes) {}

    /// Before so much is added, none of it is moved.
    void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
    /// Zeros for so many records, to be written before more is added.
    std::pair<Span, std::span<std::byte>> make(std::size_t bytes, std::size_t count) {
        const std::size_t offset = (bytes_.size() + 63) / 64 * 64;
        bytes_.resize(offset + std::max(bytes, largest_record));
        return {{static_cast<uint>(offset / 64), static_cast<uint>(count)}, std::span(bytes_).subspan(offset, bytes)};
    }
    Span add(std::span<const std::byte> records, std::size_t count) {
        const auto [span, room] = make(records.size(), count);
        std::ranges::copy(records, room.begin());
        return span;
    }
    template <class T> Span add(const std::vector<T> &records) { return add(std::as_bytes(std::span(records)), records.size()); }

private:
    std::vector<std::byte> &bytes_;
};

}  // namespace brandung
