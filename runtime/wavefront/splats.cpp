#include "runtime/wavefront/splats.h"

namespace brandung {
namespace {

/// Entries beyond a column's that kernels read; and strides that are no powers of two.
constexpr uint spare = ITEMS_PER_CHUNK;

}  // namespace

Splats::Splats(Device &device, const FilmSettings &film, const Sources &lists, uint batch)
    : weigh_(device, "kernels/stages/weigh_splats.cl", "weigh_splats", lists),
      cut_(device, "kernels/stages/cut_samples.cl", "cut_samples", {}),
      reach_(splat_reach(film)),
      intervals_(FILTER_INTERVALS / film.filter_radius),
      stride_(batch + spare),
      filter_values_(device, brandung::filter_values(filter_kinds()[film.filter])),
      weights_(device, std::size_t{stride_} * 2 * static_cast<uint>(2 * reach_ + 1)),
      values_(device, std::size_t{stride_} * 3) {
    const auto column = [&](int k) { return static_cast<uint>(k + reach_) * stride_; };
    const uint rows = column(reach_ + 1);
    for (int y = -reach_; y <= reach_; ++y)
        for (int x = -reach_; x <= reach_; ++x) all_.push_back({x, y, column(x), rows + column(y)});
}

void Splats::weigh(const Batch &batch) {
    const double columns = 2.0 * (2 * reach_ + 1);
    weigh_(Grid(batch.params.pixels, batch.params.samples), batch.params, batch.pixels, reach_, intervals_, shared(filter_values_), stride_,
           several(weights_, columns));
}

void Splats::cut(const Batch &batch, const Buffer<Sample> &samples, Buffer<uint> &clamped) {
    cut_(Grid(batch.params.pixels, batch.params.samples), batch.params, samples, stride_, several(values_, 3), shared(clamped));
}

}  // namespace brandung
