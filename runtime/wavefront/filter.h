/// Filter: from where in their pixel samples are drawn, and what they weigh.
#pragma once
#include <optional>

#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/batch.h"
#include "runtime/wavefront/splats.h"
#include "scene/filters/filter.h"
#include "scene/scene.h"

namespace brandung {

/// As kernel argument it is FILTER_PARAMS.
class Filter {
public:
    /// `lists`: the generated files of the scene; `batch`: rays per wave. Throws BuildError, and Error where the device cannot hold the tables.
    Filter(Device &device, const FilmSettings &film, const Sources &lists, uint batch);

    /// Multiplies the batch's samples by their weights, if some are negative; the others are all 1.
    void weigh(const Batch &batch, Buffer<Sample> &samples);
    /// The same of other values of the samples, for AOVs of the film that are filtered.
    void weigh(const Batch &batch, Buffer<vec3> &values);
    bool has_weights() const { return weigh_.has_value(); }
    /// If samples are splatted: these, as the last batch of weigh_splats() has them.
    const Splats *splats() const { return splats_ ? &*splats_ : nullptr; }
    Splats *splats() { return splats_ ? &*splats_ : nullptr; }
    void weigh_splats(const Batch &batch) {
        if (splats_) splats_->weigh(batch);
    }

    template <class Bind> void for_each_argument(Bind bind) const { bind(params_), bind(shared(table_)); }
    std::size_t bytes() const { return table_.bytes() + (splats_ ? splats_->bytes() : 0); }

private:
    FilterParams params_;
    Buffer<float> table_;
    std::optional<Kernel> weigh_, weigh_values_;
    std::optional<Splats> splats_;
};

}  // namespace brandung
