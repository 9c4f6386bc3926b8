/// What rough dielectrics' facets take from each other: a table for each alpha and distribution that a scene has.
#pragma once
#include <cstddef>
#include <vector>

#include "kernels/bsdfs/loss_table.h"
#include "kernels/core/scene.h"
#include "scene/bsdfs/facets.h"

namespace brandung {

/// By quadrature, within 0.004 at the table's places (rough facets near the critical angle), mostly within 0.001. Takes all threads; one would take
/// 60 ms for GGX, 130 ms for Beckmann's distribution.
LossTable loss_table_of(const Facets &facets);

/// The materials' bytes, and behind them the tables that those with MATERIAL_LOSES have then in their words, for each of which `is_used` says whether
/// anything is made of it. Without `computes` the tables are 0.
std::vector<std::byte> with_losses(std::vector<Material> materials, const std::vector<bool> &is_used, bool computes = true);

}  // namespace brandung
