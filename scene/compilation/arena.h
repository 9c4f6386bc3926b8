/// Arena: what kernels read of a scene, one array of records after another.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "kernels/core/scene.h"

namespace brandung {

/// Kernels read record 0 of an array where they have none to read.
inline constexpr std::size_t largest_record = 256;

/// Grows in records, each array at a multiple of 64 bytes.
class Arena {
public:
    explicit Arena(std::vector<std::byte> &bytes) : bytes_(bytes) {}

    Span add(std::span<const std::byte> records, std::size_t count) {
        const std::size_t offset = (bytes_.size() + 63) / 64 * 64;
        bytes_.resize(offset + std::max(records.size(), largest_record));
        std::copy(records.begin(), records.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(offset));
        return {static_cast<uint>(offset / 64), static_cast<uint>(count)};
    }
    template <class T> Span add(const std::vector<T> &records) { return add(std::as_bytes(std::span(records)), records.size()); }

private:
    std::vector<std::byte> &bytes_;
};

}  // namespace brandung
