#include "runtime/inspection/reasons.h"

#include <fmt/format.h>

#include "scene/vectors.h"

#include "kernels/lights/light.h"

namespace brandung {
namespace {

bool transmits(const Material &material) { return (material.flags & MATERIAL_TRANSMITS) != 0; }
bool is_total(const TracedRay &ray, const Material &material) { return transmits(material) && ray.description.cosine_squared_beyond < 0; }

}  // namespace

bool can_spawn(const TracedRay &parent, uint kind, const Material &material) {
    if (kind == RAY_REFRACTED) return transmits(material);
    return (material.flags & MATERIAL_REFLECTS) != 0 || is_total(parent, material);
}

const TracedChild *child_of_kind(const TracedRay &parent, uint kind) {
    for (const TracedChild &child : parent.children)
        if (RAY_KIND(child.ray.tag) == kind) return &child;
    return nullptr;
}

std::string why_not_spawned(const TracedRay &parent, uint kind, const Material &material, const IntegratorSettings &settings) {
    const TracedChild *child = child_of_kind(parent, kind);
    if (child && child->traced) return "";
    if (!can_spawn(parent, kind, material)) return kind == RAY_REFLECTED ? "the material does not reflect" : "the material does not transmit";
    if (kind == RAY_REFRACTED && is_total(parent, material)) return "total internal reflection";
    if (!child) return "the other was chosen: integrator.follow is one";
    if (parent.path.depth >= settings.max_depth) return fmt::format("depth limit: integrator.max_depth is {}", settings.max_depth);
    const float throughput = largest(parent.path.throughput * child->weight);
    if (throughput == 0) return "its throughput is 0";
    return fmt::format("its throughput, {:g}, is below integrator.threshold, {:g}", throughput, settings.threshold);
}

std::string why_not_asked(const TracedLight &light) {
    const uint refusals = light.asked ? 0u : light.description.refusals;
    if (refusals & LIGHT_NOT_SHOWN) return "the material shows no light of lights";
    if (refusals & LIGHT_BEHIND) return fmt::format("it is behind the surface: its cosine to the shading normal is {:g}", light.description.cosine);
    if (refusals & LIGHT_SENDS_NOTHING) return "it sends nothing there, as a spot light does outside its cone";
    return "";
}

}  // namespace brandung
