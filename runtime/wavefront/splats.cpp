#include "runtime/wavefront/splats.h"

namespace brandung {

Splats::Splats(Device &device, const FilmSettings &film, const Sources &lists, uint batch)
    : place_(device, "kernels/stages/place_samples.cl", "place_samples", lists),
      values_(device, brandung::filter_values(filter_kinds()[film.filter])),
      places_(device, batch) {
    const int reach = splat_reach(film);
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) all_.push_back({x, y, FILTER_INTERVALS / film.filter_radius});
}

}  // namespace brandung
