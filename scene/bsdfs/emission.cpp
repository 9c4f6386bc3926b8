/// What materials in scene files shine with.
#include "scene/bsdfs/make.h"
#include "scene/parameters.h"

namespace brandung {

void read_emission(const Parameters &parameters, Material &material) {
    material.emission = parameters.spectrum("emission", Spectrum(0));
    const uint flags[] = {0, MATERIAL_DARK_BACK, MATERIAL_DARK_FRONT};
    material.flags |= flags[parameters.choice("emission_side", {"both", "front", "back"}, 0)];
}

}  // namespace brandung
