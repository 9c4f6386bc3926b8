/// The list of material kinds.
#include "scene/bsdfs/bsdf.h"

namespace brandung {

Material read_whitted(const Parameters &parameters, Scene &scene);
Material read_diffuse(const Parameters &parameters, Scene &scene);
Material read_conductor(const Parameters &parameters, Scene &scene);
Material read_plastic(const Parameters &parameters, Scene &scene);
Material read_phong(const Parameters &parameters, Scene &scene);
Material read_dielectric(const Parameters &parameters, Scene &scene);
Material read_thin_dielectric(const Parameters &parameters, Scene &scene);
Material read_null(const Parameters &parameters, Scene &scene);

const std::vector<BsdfKind> &bsdf_kinds() {
    static const std::vector<BsdfKind> kinds = {
        {"whitted", "Whitted", read_whitted, true},
        {"diffuse", "Diffuse", read_diffuse, false},
        {"conductor", "Conductor", read_conductor, false},
        {"plastic", "Plastic", read_plastic, false},
        {"phong", "ModifiedPhong", read_phong, false},
        {"dielectric", "Dielectric", read_dielectric, false},
        {"thin_dielectric", "ThinDielectric", read_thin_dielectric, false},
        {"null", "Null", read_null, false},
    };
    return kinds;
}

}  // namespace brandung
