#include <tuple>

#include "runtime/integrators/integrator.h"
#include "scene/error.h"
#include "scene/formats/tokens.h"

namespace brandung {

std::unique_ptr<Integrator> make_whitted(const IntegratorJob &job);
std::unique_ptr<Integrator> make_path(const IntegratorJob &job);

const std::vector<IntegratorKind> &integrator_kinds() {
    static const std::vector<IntegratorKind> kinds = {
        {"whitted", make_whitted},
        {"path", make_path},
        {"distributed", make_path},
    };
    return kinds;
}

const IntegratorKind &integrator_of(const Scene &scene) {
    const auto &[name, place] = std::tie(scene.integrator.type, scene.integrator.type_place);
    std::string known;
    for (const IntegratorKind &kind : integrator_kinds()) {
        if (kind.name == name) return kind;
        known += std::string(known.empty() ? "" : ", ") + kind.name;
    }
    throw SceneError((place.empty() ? scene.file : place) + ": there is no " + quoted(name) + ", only " + known);
}

}  // namespace brandung
