/// Work on many items on all processors, with results that do not depend on how many these are.
#pragma once
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "runtime/selftest/findings.h"

namespace brandung {

inline constexpr std::size_t examined_at_once = 4096;  ///< a multiple of BLOCK_SIZE

/// Calls `work(first, last)` for parts of 0 ... count - 1.
template <class Work> void for_parts(std::size_t count, Work work) {
    const std::size_t parts = (count + examined_at_once - 1) / examined_at_once;
    tbb::parallel_for(std::size_t{0}, parts,
                      [&](std::size_t part) { work(part * examined_at_once, std::min(count, (part + 1) * examined_at_once)); });
}

/// Calls `look(i, findings)` for every item, and gives all findings, whose first fault is that of the lowest item.
template <class Look> Findings examine_each(std::size_t count, Look look) {
    std::vector<Findings> parts((count + examined_at_once - 1) / examined_at_once);
    for_parts(count, [&](std::size_t first, std::size_t last) {
        Findings &findings = parts[first / examined_at_once];
        for (std::size_t i = first; i < last; ++i) ++findings.inputs, look(i, findings);
    });
    Findings all;
    for (const Findings &findings : parts) all.add(findings);
    return all;
}

}  // namespace brandung
