#include "runtime/wavefront/filter.h"

#include <algorithm>

#include "scene/aovs/aov.h"

namespace brandung {
namespace {

/// Of filters that samples are drawn from; splats are drawn from the box. Buffers have at least one element.
std::vector<float> table_or_nothing(const FilmSettings &film) {
    std::vector<float> table;
    if (!splats(film)) table = filter_table(filter_kinds()[film.filter], film.filter_radius);
    if (table.empty()) table.push_back(0);
    return table;
}

/// A single sample in the middle of its pixel is not drawn from the filter.
bool is_drawn(const FilmSettings &film) { return film.spp > 1 || film.pixel == PIXEL_RANDOM; }

bool has_filtered_aovs(const FilmSettings &film) {
    return std::any_of(film.aovs.begin(), film.aovs.end(), [](uint kind) { return aov_kinds()[kind].what == AovKind::filtered; });
}

}  // namespace

Filter::Filter(Device &device, const FilmSettings &film, const Sources &lists, uint batch)
    : params_(filter_params(filter_kinds()[film.filter], film.filter_radius)), table_(device, table_or_nothing(film)) {
    if (brandung::splats(film)) splats_.emplace(device, film, lists, batch);
    if (!(params_.negative_tail > 0 && is_drawn(film))) return;
    weigh_.emplace(device, "kernels/stages/weigh_samples.cl", "weigh_samples", lists);
    if (has_filtered_aovs(film)) weigh_values_.emplace(device, "kernels/stages/weigh_values.cl", "weigh_values", lists);
}

void Filter::weigh(const Batch &batch, Buffer<Sample> &samples) {
    if (weigh_) (*weigh_)(batch.count(), batch.params, params_, several(batch.pixels, 1.0 / batch.params.samples), batch.count(), updated(samples));
}

void Filter::weigh(const Batch &batch, Buffer<vec3> &values) {
    if (weigh_values_)
        (*weigh_values_)(batch.count(), batch.params, params_, several(batch.pixels, 1.0 / batch.params.samples), batch.count(), updated(values));
}

}  // namespace brandung
