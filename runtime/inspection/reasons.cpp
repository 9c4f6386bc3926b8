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

std::string why_not_continued(const TracedRay &parent, const TracedChild &child, const IntegratorSettings &settings) {
    if (child.traced) return "";
    const NextDescription &chosen = child.chosen.value();
    if (chosen.refusals & PATH_ABSORBED) return "the surface sends nothing there";
    if (chosen.refusals & PATH_ACROSS) return "it leads through the surface itself, though its shading normal says otherwise";
    if (surface_number(parent) > settings.max_depth) return fmt::format("depth limit: integrator.max_depth is {}", settings.max_depth);
    if (chosen.refusals & PATH_ENDED)
        return fmt::format("roulette: {:g} is not below the chance to go on, {:g}; integrator.roulette_depth is {}", chosen.roulette, chosen.survival,
                           settings.roulette_depth);
    return "its throughput is 0";
}

std::string why_not_asked(const TracedLight &light) {
    const uint refusals = light.asked ? 0u : light.description.refusals;
    if (refusals & LIGHT_NOT_SHOWN) return "the material shows no light of lights";
    if (refusals & LIGHT_BEHIND) return fmt::format("it is behind the surface: its cosine to the shading normal is {:g}", light.description.cosine);
    if (refusals & LIGHT_SENDS_NOTHING) return "it sends nothing there, as a spot light does outside its cone";
    if (refusals & LIGHT_NOT_SCATTERED) return "the material scatters none of it back along the ray";
    if (refusals & LIGHT_ACROSS) return "the surface itself is in the way, though its shading normal says otherwise";
    return light.chosen && !light.asked ? "what it adds is 0" : "";
}

}  // namespace brandung
