/// The list of light kinds.
#include "scene/lights/light.h"

namespace brandung {

Light read_point(const Parameters &parameters);
Light read_directional(const Parameters &parameters);
Light read_spot(const Parameters &parameters);
Spectrum power_of_point(const Light &light, float extent);
Spectrum power_of_directional(const Light &light, float extent);
Spectrum power_of_spot(const Light &light, float extent);
Spectrum power_of_emissive_flat(const Light &light, float extent);
Spectrum power_of_emissive_mesh(const Light &light, float extent);
Spectrum power_of_emissive_sphere(const Light &light, float extent);
Spectrum power_of_emissive_frustum(const Light &light, float extent);
Spectrum power_of_emissive_disk(const Light &light, float extent);
Spectrum power_of_environment(const Light &light, float extent);

const std::vector<LightKind> &light_kinds() {
    static const std::vector<LightKind> kinds = {
        {"point", "PointLight", power_of_point, false, read_point},
        {"directional", "DirectionalLight", power_of_directional, true, read_directional},
        {"spot", "SpotLight", power_of_spot, false, read_spot},
        {"emissive_mesh", "EmissiveMesh", power_of_emissive_mesh, false, nullptr},
        {"emissive_sphere", "EmissiveSphere", power_of_emissive_sphere, false, nullptr},
        {"emissive_frustum", "EmissiveFrustum", power_of_emissive_frustum, false, nullptr},
        {"environment", "Environment", power_of_environment, true, nullptr},
        {"emissive_flat", "EmissiveFlat", power_of_emissive_flat, false, nullptr},
        {"emissive_disk", "EmissiveDisk", power_of_emissive_disk, false, nullptr},
    };
    return kinds;
}

const std::vector<LightKind> &lights_of_files() {
    static const std::vector<LightKind> kinds = [] {
        std::vector<LightKind> kinds = light_kinds();
        std::erase_if(kinds, [](const LightKind &kind) { return kind.read == nullptr; });
        return kinds;
    }();
    return kinds;
}

}  // namespace brandung
