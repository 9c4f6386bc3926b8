/// Where to split a range of references: the surface area heuristic over bins of centres.
#pragma once
#include <span>

#include "scene/accelerators/kind_box.h"

namespace brandung {

struct Extent {
    KindBox boxes = KindBox::nothing(), centres = KindBox::nothing();  ///< of the references; of half their centres

    void add(const SortedReference &reference) {
        const Point4 centre = reference.box.half_centre();
        boxes.add(reference.box), centres.add(centre, centre);
    }
    void add(const Extent &other) { boxes.add(other.boxes), centres.add(other.centres); }
};
Extent measure(std::span<const SortedReference> references);

/// A plane between two bins of one axis.
struct Split {
    uint axis = 0;
    float base = 0, scale = 0;
    int last = -1;         ///< last bin of the first side, -1: there is no split
    uint first_count = 0;  ///< references of the first side

    bool exists() const { return last >= 0; }
    bool is_first(const SortedReference &reference) const { return int((reference.box.half_centre(axis) - base) * scale) <= last; }
};

/// The cheapest split of references, whose extent is given; a side costs its area times the blocks that its references would fill, kind by kind.
/// Mixtures that fit into a block are split by kind only. No split exists where all centres coincide.
Split choose_split(std::span<const SortedReference> references, const KindBox &centres, const RelativeArea &area);

}  // namespace brandung
