#include "scene/accelerators/binned_sah.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace brandung {
namespace {

constexpr uint min_bins = 8, max_bins = 32;  ///< fewer cost a ray more steps
constexpr size_t grain = 32768;              ///< references of a task

using References = std::span<const SortedReference>;

/// `add` adds references to a sum. Only minima, maxima and counts of integers are taken, so how they are cut into tasks doesn't show.
template <class Sum, class Add> void reduce(References references, Sum &sum, const Add &add) {
    if (references.size() <= grain) {
        add(sum, references);
    } else {
        const tbb::blocked_range<size_t> all(0, references.size(), grain);
        const auto add_piece = [&](const tbb::blocked_range<size_t> &piece, const Sum &before) {
            Sum partial = before;
            add(partial, references.subspan(piece.begin(), piece.size()));
            return partial;
        };
        const auto join = [](const Sum &a, const Sum &b) {
            Sum sum = a;
            sum.add(b);
            return sum;
        };
        sum = tbb::parallel_reduce(all, sum, add_piece, join);
    }
}

/// Numbers of references. Most ranges hold one kind, and need but one.
struct OneKind {
    uint count = 0;

    uint total() const { return count; }
    void add(uint) { ++count; }
    void add(const OneKind &other) { count += other.count; }
    uint blocks() const { return (count + BLOCK_SIZE - 1) / BLOCK_SIZE; }
};
struct ManyKinds {
    std::array<uint, MAX_PRIMITIVE_KINDS> counts{};

    uint total() const {
        uint total = 0;
        for (const uint count : counts) total += count;
        return total;
    }
    void add(uint kind) { ++counts[kind]; }
    void add(const ManyKinds &other) {
        for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) counts[kind] += other.counts[kind];
    }
    uint blocks() const {
        uint blocks = 0;
        for (const uint count : counts) blocks += (count + BLOCK_SIZE - 1) / BLOCK_SIZE;
        return blocks;
    }
};

/// How references fall into bins along all axes. Both ends of an axis with extent hold some; along others all are in the first bin.
struct Binning {
    typedef int Places __attribute__((vector_size(4 * axes)));

    Point4 base, scale;

    Binning(const KindBox &centres, uint count) : base(centres.low) {
        for (uint axis = 0; axis < axes; ++axis) {
            const float extent = centres.high[axis] - centres.low[axis];
            scale[axis] = extent < 1e-30f ? 0 : 0.9999f * float(count) / extent;  // it stays finite
        }
    }
    /// By the formula of Split::is_first().
    Places places(const KindBox &box) const { return __builtin_convertvector((box.half_centre() - base) * scale, Places); }
};

template <class Counts> struct BinsOfAxis {
    alignas(32) std::array<KindBox, max_bins> boxes;
    std::array<Counts, max_bins> counts;
};

/// Boxes and numbers of what is in the bins of some axes.
template <class Counts, uint first_axis, uint last_axis> class Bins {
public:
    explicit Bins(uint count) : count_(count) { clear(); }

    void add(References references, const Binning &binning) {
        size_t done = 0;
        if (references.size() >= 256) {
            // Neighbours fall in the same bins, and one waits for the other there: with two sets of bins, half as long.
            Bins others(count_);
            const size_t half = references.size() / 2;
            for (; done < half; ++done) add(references[done], binning), others.add(references[half + done], binning);
            done *= 2;
            add(others);
        }
        for (; done < references.size(); ++done) add(references[done], binning);
    }
    void add(const Bins &other) {
        for (uint axis = first_axis; axis <= last_axis; ++axis) {
            for (uint bin = 0; bin < count_; ++bin) {
                of_[axis].boxes[bin].add(other.of_[axis].boxes[bin]);
                of_[axis].counts[bin].add(other.of_[axis].counts[bin]);
            }
        }
    }
    const BinsOfAxis<Counts> &of(uint axis) const { return of_[axis]; }

private:
    void add(const SortedReference &reference, const Binning &binning) {
        const Binning::Places places = binning.places(reference.box);
        for (uint axis = first_axis; axis <= last_axis; ++axis) {
            of_[axis].boxes[uint(places[axis])].add(reference.box);
            of_[axis].counts[uint(places[axis])].add(reference.box.kind());
        }
    }
    void clear() {
        for (uint axis = first_axis; axis <= last_axis; ++axis) {
            std::fill_n(of_[axis].boxes.begin(), count_, KindBox::nothing());
            of_[axis].counts.fill({});
        }
    }

    uint count_;
    std::array<BinsOfAxis<Counts>, last_axis + 1> of_;
};

struct Candidate {
    float cost = FLT_MAX;
    uint axis = 0;
    int last = -1;
};

template <class Counts> void try_axis(const BinsOfAxis<Counts> &bins, uint count, uint axis, const RelativeArea &area, Candidate &best) {
    std::array<float, max_bins> second_cost;
    KindBox box = KindBox::nothing();
    Counts counts;
    for (uint bin = count - 1; bin > 0; --bin) {
        box.add(bins.boxes[bin]), counts.add(bins.counts[bin]);
        second_cost[bin - 1] = area(box) * float(counts.blocks());
    }
    box = KindBox::nothing(), counts = Counts();
    float least = FLT_MAX;
    int last = -1;
    for (uint bin = 0; bin + 1 < count; ++bin) {
        box.add(bins.boxes[bin]), counts.add(bins.counts[bin]);
        const float cost = area(box) * float(counts.blocks()) + second_cost[bin];
        last = cost < least ? int(bin) : last;
        least = std::min(cost, least);
    }
    if (least < best.cost) best = {least, axis, last};
}

template <class Counts, uint first_axis, uint last_axis>
Split choose(References references, const KindBox &centres, uint count, const RelativeArea &area) {
    const Binning binning(centres, count);
    using Sum = Bins<Counts, first_axis, last_axis>;
    Sum bins(count);
    reduce(references, bins, [&](Sum &sum, References piece) { sum.add(piece, binning); });
    Candidate best;
    for (uint axis = first_axis; axis <= last_axis; ++axis)
        if (binning.scale[axis] > 0) try_axis(bins.of(axis), count, axis, area, best);
    Split split{.axis = best.axis, .base = binning.base[best.axis], .scale = binning.scale[best.axis], .last = best.last};
    for (int bin = 0; bin <= split.last; ++bin) split.first_count += bins.of(split.axis).counts[uint(bin)].total();
    return split;
}

/// A range with few references would mostly weigh the same splits twice.
uint bin_count(size_t references) { return uint(std::clamp<size_t>(references / 2, min_bins, max_bins)); }

}  // namespace

Extent measure(References references) {
    Extent extent;
    reduce(references, extent, [](Extent &sum, References piece) {
        for (const SortedReference &reference : piece) sum.add(reference);
    });
    return extent;
}

Split choose_split(References references, const KindBox &centres, const RelativeArea &area) {
    const uint count = bin_count(references.size());
    if (centres.one_kind()) return choose<OneKind, 0, kind_axis - 1>(references, centres, count, area);
    if (references.size() <= BLOCK_SIZE) return choose<ManyKinds, kind_axis, kind_axis>(references, centres, max_bins, area);
    return choose<ManyKinds, 0, kind_axis>(references, centres, count, area);
}

}  // namespace brandung
