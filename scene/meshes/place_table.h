/// PlaceTable: where in a list a thing is, by its hash.
#pragma once
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// Spreads the bits of numbers over a hash (the finalizer of MurmurHash3, A. Appleby).
template <class... Numbers> uint hash_of(Numbers... numbers) {
    uint64 hash = 0;
    const auto add = [&](uint number) {
        hash = (hash ^ number) * 0xff51afd7ed558ccdull;
        hash ^= hash >> 33;
    };
    (add(numbers), ...);
    return uint(hash * 0xc4ceb9fe1a85ec53ull >> 32);
}

/// An open hash table of places in a list. The list itself, and what is equal there, is its user's.
class PlaceTable {
public:
    static constexpr uint none = 0xffffffffu;

    void clear() { entries_.assign(smallest, {}), used_ = 0; }
    /// The place of a thing of this hash for which `is_at(place)` holds; if there is none, `next`, which becomes its place.
    template <class IsAt> uint find_or_add(uint hash, uint next, const IsAt &is_at) {
        if (2 * (used_ + 1) > entries_.size()) grow();
        std::size_t i = hash & (entries_.size() - 1);
        while (entries_[i].place != none) {
            if (entries_[i].hash == hash && is_at(entries_[i].place)) return entries_[i].place;
            i = (i + 1) & (entries_.size() - 1);
        }
        entries_[i] = {hash, next};
        ++used_;
        return next;
    }

private:
    static constexpr std::size_t smallest = 16;
    struct Entry {
        uint hash = 0, place = none;
    };

    void grow() {
        std::vector<Entry> before(2 * entries_.size());
        before.swap(entries_);
        for (const Entry &entry : before) {
            if (entry.place == none) continue;
            std::size_t i = entry.hash & (entries_.size() - 1);
            while (entries_[i].place != none) i = (i + 1) & (entries_.size() - 1);
            entries_[i] = entry;
        }
    }

    std::vector<Entry> entries_ = std::vector<Entry>(smallest);  ///< a power of two, at most half of them used
    std::size_t used_ = 0;
};

}  // namespace brandung
