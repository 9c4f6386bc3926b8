/// Compaction: stable lists of the live ones among slots.
#pragma once
#include "runtime/opencl/kernel.h"

namespace brandung {

/// Rows of slots are packed independently of one another.
class Compaction {
public:
    Compaction(Device &device, std::size_t slots_per_row, std::size_t rows);

    /// Row r of `list`, from r * stride + list_first on, becomes base + slot of every slot with alive[slot] != 0, slots r * stride ... + count.
    void operator()(const Buffer<std::uint8_t> &alive, uint stride, uint count, uint rows, uint base, uint list_first, Buffer<uint> &list);

    /// How many were live, per row of the last call.
    const Buffer<uint> &counts() const { return counts_; }

    std::size_t bytes() const { return chunk_counts_.bytes() + counts_.bytes(); }

private:
    Kernel count_live_, write_live_;
    Buffer<uint> chunk_counts_, counts_;
};

}  // namespace brandung
