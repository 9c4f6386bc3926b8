/// The list of samplers; the first is the default.
#include "scene/samplers/sampler.h"

namespace brandung {

const std::vector<SamplerKind> &sampler_kinds() {
    static const std::vector<SamplerKind> kinds = {
        {"sobol"},
        {"independent"},
        {"stratified"},
        {"blue_noise"},
    };
    return kinds;
}

}  // namespace brandung
