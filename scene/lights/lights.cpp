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
    };
    return kinds;
}

}  // namespace brandung
