#include "runtime/wavefront/filter.h"

namespace brandung {
namespace {

/// Buffers have at least one element.
std::vector<float> table_or_nothing(const FilterKind &kind, float radius) {
    std::vector<float> table = filter_table(kind, radius);
    if (table.empty()) table.push_back(0);
    return table;
}

/// A single sample in the middle of its pixel is not drawn from the filter.
bool is_drawn(const FilmSettings &film) { return film.spp > 1 || film.pixel == PIXEL_RANDOM; }

}  // namespace

Filter::Filter(Device &device, const FilmSettings &film, const Sources &lists)
    : params_(filter_params(filter_kinds()[film.filter], film.filter_radius)),
      table_(device, table_or_nothing(filter_kinds()[film.filter], film.filter_radius)) {
    if (params_.negative_tail > 0 && is_drawn(film)) weigh_.emplace(device, "kernels/stages/weigh_samples.cl", "weigh_samples", lists);
}

void Filter::weigh(const Batch &batch, Buffer<Sample> &samples) {
    if (weigh_) (*weigh_)(batch.count(), batch.params, params_, batch.pixels, batch.count(), samples);
}

}  // namespace brandung
