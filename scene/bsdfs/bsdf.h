/// Kinds of materials.
#pragma once
#include <vector>

#include "kernels/bsdfs/whitted.h"
#include "kernels/core/scene.h"

namespace brandung {

class Parameters;
struct Scene;

/// `kernels/bsdfs/<name>.cl` has its device functions; Material.kind is its place in bsdf_kinds().
struct BsdfKind {
    const char *name;                                              ///< in scene files and as prefix of device functions
    const char *record;                                            ///< its view of Material.words
    Material (*read)(const Parameters &parameters, Scene &scene);  ///< may add textures to the scene
    bool is_whitted;                                               ///< has the functions that Whitted's integrator asks for (kernels/bsdfs/bsdf.cl)
};
const std::vector<BsdfKind> &bsdf_kinds();
/// Sets kind, words and the flags that follow from them; eta, priority and emission are the caller's.
Material make_material(const Whitted &whitted);
/// Lets so much of the light pass straight on.
Material make_null(Spectrum transmission);

}  // namespace brandung
