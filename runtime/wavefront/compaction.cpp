#include "runtime/wavefront/compaction.h"

#include "kernels/stages/compact.h"

namespace brandung {
namespace {

constexpr const char *file = "kernels/stages/compact.cl";

}  // namespace

Compaction::Compaction(Device &device, std::size_t slots_per_row, std::size_t rows)
    : count_live_(device, file, "count_live", {}, COMPACT_CHUNK),
      scan_counts_(device, file, "scan_counts", {}, 1),
      write_live_(device, file, "write_live", {}, COMPACT_CHUNK),
      chunk_counts_(device, count_live_.work_items(slots_per_row) * rows),
      counts_(device, rows) {}

void Compaction::operator()(const Buffer<std::uint8_t> &alive, uint stride, uint count, uint rows, uint base, uint list_first, Buffer<uint> &list) {
    const Access slots = in_rows(alive, rows);
    count_live_(Grid(count, rows), slots, stride, count, several(chunk_counts_, 1.0 / COMPACT_CHUNK));
    scan_counts_(Grid(1, rows), data_dependent(chunk_counts_), static_cast<uint>(count_live_.work_items(count)), shared(counts_));
    write_live_(Grid(count, rows), slots, stride, count, several(chunk_counts_, 1.0 / COMPACT_CHUNK), base, list_first, data_dependent(list));
}

}  // namespace brandung
