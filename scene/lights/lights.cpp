/// The list of light kinds.
#include "scene/lights/light.h"

namespace brandung {

Light read_point(const Parameters &parameters);
Light read_directional(const Parameters &parameters);
Light read_spot(const Parameters &parameters);

const std::vector<LightKind> &light_kinds() {
    static const std::vector<LightKind> kinds = {
        {"point", "PointLight", true, read_point},
        {"directional", "DirectionalLight", false, read_directional},
        {"spot", "SpotLight", true, read_spot},
        {"emissive_mesh", "EmissiveMesh", false, nullptr},
        {"emissive_sphere", "EmissiveSphere", false, nullptr},
        {"emissive_frustum", "EmissiveFrustum", false, nullptr},
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
