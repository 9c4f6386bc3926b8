/// The list of material kinds.
#include "scene/bsdfs/bsdf.h"

namespace brandung {

Material read_whitted(const Parameters &parameters, Scene &scene);

const std::vector<BsdfKind> &bsdf_kinds() {
    static const std::vector<BsdfKind> kinds = {
        {"whitted", "Whitted", read_whitted},
    };
    return kinds;
}

}  // namespace brandung
