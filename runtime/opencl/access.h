/// Access: how a kernel uses an array, where it is not the rule, which is that each item reads or writes one record of it.
#pragma once
#include <algorithm>
#include <optional>

#include "runtime/opencl/buffer.h"

namespace brandung {

struct Access {
    const RawBuffer &buffer;
    std::optional<double> item_bytes;  ///< that an item reads and writes; nothing where that depends on what the records say
    double items;                      ///< of one row of a launch, for which the array has room; 0 where it is no queue of items
};

/// One record for each item, or none of an array that is empty since the scene does without it.
template <class T> Access one_each(const Buffer<T> &buffer) {
    return {buffer, buffer.size() > 0 ? sizeof(T) : 0.0, static_cast<double>(buffer.size())};
}
/// So many records for each item: below 1 where several items share one.
template <class T> Access several(const Buffer<T> &buffer, double records) {
    if (buffer.size() == 0 || records == 0) return one_each(buffer);
    return {buffer, records * sizeof(T), static_cast<double>(buffer.size()) / records};
}
/// One record for each item of each of so many rows.
template <class T> Access in_rows(const Buffer<T> &buffer, std::size_t rows) {
    return {buffer, sizeof(T), static_cast<double>(buffer.size()) / static_cast<double>(rows)};
}
/// A record that the item finds by a number, reads and writes.
template <class T> Access updated(const Buffer<T> &buffer) { return {buffer, 2.0 * sizeof(T), 0}; }
/// A few records, the same for all items: tables, counters, a sum per work-item.
inline Access shared(const RawBuffer &buffer) { return {buffer, 0, 0}; }
/// As many records as what they say leads to: of the kernel's bytes nothing is known.
inline Access data_dependent(const RawBuffer &buffer) { return {buffer, {}, 0}; }

/// What a launch's arrays tell of it together.
struct Traffic {
    std::optional<double> item_bytes = 0;
    double capacity = 0;  ///< items in one row of the largest launch that its queues have room for; 0 if it has none

    void add(const Access &access) {
        item_bytes = item_bytes && access.item_bytes ? std::optional(*item_bytes + *access.item_bytes) : std::nullopt;
        if (access.items > 0) capacity = capacity > 0 ? std::min(capacity, access.items) : access.items;
    }
};

}  // namespace brandung
