#include "scene/accelerators/binned_sah.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace brandung {
namespace {

constexpr uint max_bins = 32;    ///< fewer cost a ray more steps
constexpr size_t grain = 32768;  ///< references of a task

using References = std::span<const SortedReference>;

/// `fill` adds references to a result. Only minima, maxima and counts of integers are taken, so how they are cut into tasks doesn't show.
template <class Result, class Fill> void reduce(References references, Result &result, const Fill &fill) {
    if (references.size() <= grain) {
        fill(result, references);
    } else {
        const tbb::blocked_range<size_t> all(0, references.size(), grain);
        const auto fill_piece = [&](const tbb::blocked_range<size_t> &piece, Result partial) {
            fill(partial, references.subspan(piece.begin(), piece.size()));
            return partial;
        };
        const auto join = [](Result a, const Result &b) {
            a.add(b);
            return a;
        };
        result = tbb::parallel_reduce(all, Result{}, fill_piece, join);
    }
}

struct Measure : Extent {
    void add(const Measure &other) { boxes.add(other.boxes), centres.add(other.centres); }
};

struct Bin {
    KindBox box = KindBox::nothing();
    std::array<uint, MAX_PRIMITIVE_KINDS> counts{};

    void add(const Bin &other) {
        box.add(other.box);
        for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) counts[kind] += other.counts[kind];
    }
    double cost(double pad) const {
        uint blocks = 0;
        for (const uint count : counts) blocks += (count + BLOCK_SIZE - 1) / BLOCK_SIZE;
        return box.half_area(pad) * blocks;
    }
};

struct Bins {
    std::array<Bin, max_bins> of;

    void add(const Bins &other) {
        for (uint bin = 0; bin < max_bins; ++bin) of[bin].add(other.of[bin]);
    }
};

/// A range with fewer references than bins would mostly weigh the same splits twice.
uint bin_count(size_t references) { return uint(std::min<size_t>(max_bins, references)); }

struct Candidate {
    Split split;
    double cost = DBL_MAX;
};

void try_axis(const Bins &bins, uint count, Split split, double pad, Candidate &best) {
    std::array<double, max_bins> second_cost;
    Bin second;
    for (uint bin = count - 1; bin > 0; --bin) {
        second.add(bins.of[bin]);
        second_cost[bin - 1] = second.box.empty() ? DBL_MAX : second.cost(pad);
    }
    Bin first;
    for (uint bin = 0; bin + 1 < count; ++bin) {
        first.add(bins.of[bin]);
        const double cost = first.box.empty() ? DBL_MAX : first.cost(pad) + second_cost[bin];
        if (cost < best.cost) {
            split.last = int(bin);
            best = {split, cost};
        }
    }
}

}  // namespace

Extent measure(References references) {
    Measure extent;
    reduce(references, extent, [](Measure &sum, References piece) {
        for (const SortedReference &reference : piece) {
            const Point4 centre = reference.box.half_centre();
            sum.boxes.add(reference.box);
            sum.centres.add(centre, centre);
        }
    });
    return extent;
}

Split choose_split(References references, const KindBox &centres, double pad) {
    const bool by_kind_only = references.size() <= BLOCK_SIZE && !centres.one_kind();
    const uint count = by_kind_only ? max_bins : bin_count(references.size());
    Candidate best;
    for (uint axis = by_kind_only ? kind_axis : 0; axis < axes; ++axis) {
        const float extent = centres.high[axis] - centres.low[axis];
        if (extent < 1e-30f) continue;  // the scale below stays finite
        const Split split{.axis = axis, .base = centres.low[axis], .scale = 0.9999f * float(count) / extent};
        Bins bins;
        reduce(references, bins, [&](Bins &sum, References piece) {
            for (const SortedReference &reference : piece) {
                Bin &bin = sum.of[split.bin(reference.box.half_centre(axis))];
                bin.box.add(reference.box);
                ++bin.counts[reference.box.kind()];
            }
        });
        try_axis(bins, count, split, pad, best);
    }
    return best.split;
}

}  // namespace brandung
