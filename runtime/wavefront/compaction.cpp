#include "runtime/wavefront/compaction.h"

#include "kernels/stages/compact.h"

namespace brandung {
namespace {

constexpr const char *file = "kernels/stages/compact.cl";

}  // namespace

Compaction::Compaction(Device &device, std::size_t slots_per_row, std::size_t rows)
    : count_live_(device, file, "count_live", {}, COMPACT_CHUNK),
      write_live_(device, file, "write_live", {}, COMPACT_CHUNK),
      chunk_counts_(device, count_live_.work_items(slots_per_row) * rows),
      counts_(device, rows) {}

void Compaction::operator()(const Buffer<std::uint8_t> &alive, uint stride, uint count, uint rows, uint base, uint list_first, Buffer<uint> &list) {
    if (count == 0) return counts_.fill_zero();
    const Access slots = in_rows(alive, rows);
    count_live_(Grid(count, rows), slots, stride, count, several(chunk_counts_, 1.0 / COMPACT_CHUNK));
    write_live_(Grid(count, rows), slots, stride, count, several(chunk_counts_, 1.0 / COMPACT_CHUNK), base, list_first, data_dependent(list),
                shared(counts_));
}

}  // namespace brandung
