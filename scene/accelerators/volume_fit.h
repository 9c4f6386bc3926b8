/// Volumes round groups of objects, and how many lines through a box meet them.
#pragma once
#include <array>
#include <span>

#include "kernels/accelerators/bounding_volumes.h"
#include "scene/bounds.h"
#include "scene/primitives/hull.h"

namespace brandung {

/// By kind (VOLUME_...), of which VOLUME_NONE has none.
using FittedVolumes = std::array<Volume, VOLUME_KINDS>;

/// Round all parts, as tight as simple rules make them: a sphere round the middle of the parts' box; an ellipsoid and an
/// oriented box along the parts' principal axes; four diagonal slabs. Rounding of their words, to 2^-24 of the
/// scene's extent or 2^-14 of an ellipsoid's least axis, is within the margin of the tests in kernels/accelerators/volumes.cl.
FittedVolumes fit_volumes(std::span<const HullPart> parts);

/// The part of all lines through a box that also meet a volume, from 0 to 1: what comes of a fixed few lines, of every direction and place alike.
double part_of_lines(uint kind, const Volume &volume, const Bounds &box);

}  // namespace brandung
