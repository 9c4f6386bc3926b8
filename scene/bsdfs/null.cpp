/// Surfaces that are not there in scene files.
#include "kernels/bsdfs/null.h"

#include "scene/bsdfs/make.h"
#include "scene/parameters.h"

namespace brandung {

Material make_null(Spectrum transmission) { return material_of_kind("null", 0, Null{transmission}); }

Material read_null(const Parameters &parameters, Scene &) { return make_null(parameters.fraction("transmission", Spectrum(1))); }

}  // namespace brandung
