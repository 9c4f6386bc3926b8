/// The list of light kinds.
#include "scene/lights/light.h"

namespace brandung {

Light read_point(const Parameters &parameters);
Light read_directional(const Parameters &parameters);
Light read_spot(const Parameters &parameters);

const std::vector<LightKind> &light_kinds() {
    static const std::vector<LightKind> kinds = {
        {"point", "PointLight", read_point},
        {"directional", "DirectionalLight", read_directional},
        {"spot", "SpotLight", read_spot},
        {"emissive_mesh", "EmissiveMesh", nullptr},
        {"emissive_sphere", "EmissiveSphere", nullptr},
        {"emissive_frustum", "EmissiveFrustum", nullptr},
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
