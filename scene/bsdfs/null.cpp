/// Surfaces that are not there in scene files.
#include "kernels/bsdfs/null.h"

#include "scene/bsdfs/make.h"
#include "scene/parameters.h"
#include "scene/vectors.h"

namespace brandung {

Material make_null(Spectrum transmission) { return material_of_kind("null", largest(transmission) > 0 ? MATERIAL_IDEAL : 0, Null{transmission}); }

Material read_null(const Parameters &parameters, Scene &) { return make_null(parameters.fraction("transmission", Spectrum(1))); }

}  // namespace brandung
