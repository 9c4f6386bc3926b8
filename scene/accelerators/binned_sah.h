/// Where to split a range of references: the surface area heuristic over bins of centres.
#pragma once
#include <span>

#include "scene/accelerators/kind_box.h"

namespace brandung {

struct Extent {
    KindBox boxes = KindBox::nothing(), centres = KindBox::nothing();  ///< of the references; of half their centres
};
Extent measure(std::span<const SortedReference> references);

/// A plane between two bins of one axis.
struct Split {
    uint axis = 0;
    float base = 0, scale = 0;
    int last = -1;  ///< last bin of the first side, -1: there is no split

    bool exists() const { return last >= 0; }
    int bin(float half_centre) const { return int((half_centre - base) * scale); }
    bool is_first(const SortedReference &reference) const { return bin(reference.box.half_centre(axis)) <= last; }
};

/// The cheapest split; a side costs its area times the blocks that its references would fill, kind by kind. `pad` is that of half_area.
/// Mixtures that fit into a block are split by kind only. No split exists where all centres coincide.
Split choose_split(std::span<const SortedReference> references, const KindBox &centres, double pad);

}  // namespace brandung
