/// The list of light kinds.
#include "scene/lights/light.h"

namespace brandung {

Light read_point(const Parameters &parameters);
Light read_directional(const Parameters &parameters);

const std::vector<LightKind> &light_kinds() {
    static const std::vector<LightKind> kinds = {
        {"point", "PointLight", read_point},
        {"directional", "DirectionalLight", read_directional},
    };
    return kinds;
}

}  // namespace brandung
