#include "tools/report.h"

#include <fmt/core.h>

#include "scene/bsdfs/bsdf.h"
#include "scene/lights/light.h"

namespace brandung {
namespace {

using nlohmann::json;

std::vector<std::string> features_in_use(const Scene &scene, const CompiledScene &compiled) {
    std::vector<std::string> used;
    for (const PrimitiveKind *kind : compiled.primitives) used.push_back(std::string("primitive ") + kind->name);
    for (const uint kind : compiled.bsdfs) used.push_back(std::string("material ") + bsdf_kinds()[kind].name);
    for (const uint kind : compiled.lights) used.push_back(std::string("light ") + light_kinds()[kind].name);
    used.push_back("accelerator " + compiled.accelerator);
    used.push_back("integrator " + scene.integrator.type);
    if (compiled.reflects) used.push_back("reflected rays");
    if (compiled.transmits) used.push_back(fmt::format("refracted rays, lists of {} media", compiled.interior_size));
    return used;
}

/// Kinds that the program knows and this scene has none of.
std::vector<Skipped> kinds_not_in_use(const CompiledScene &compiled) {
    std::vector<Skipped> skipped;
    for (const PrimitiveKind *kind : primitive_kinds())
        if (std::find(compiled.primitives.begin(), compiled.primitives.end(), kind) == compiled.primitives.end())
            skipped.push_back({std::string("primitive ") + kind->name, "the scene has none"});
    for (uint kind = 0; kind < light_kinds().size(); ++kind)
        if (std::find(compiled.lights.begin(), compiled.lights.end(), kind) == compiled.lights.end())
            skipped.push_back({std::string("light ") + light_kinds()[kind].name, "the scene has none"});
    return skipped;
}

std::vector<Skipped> all_skipped(const CompiledScene &compiled, const Integrator &integrator) {
    std::vector<Skipped> skipped = kinds_not_in_use(compiled);
    for (const Skipped &other : integrator.skipped()) skipped.push_back(other);
    return skipped;
}

json ray_statistics(const RayCounts &counts) {
    const char *names[RAY_KINDS] = {"camera", "reflected", "refracted", "shadow"};
    json rays;
    for (uint kind = 0; kind < RAY_KINDS; ++kind) {
        rays[names[kind]] = counts.rays[kind];
        rays[std::string(names[kind]) + "_hits"] = counts.hits[kind];
    }
    rays["total"] = counts.total();
    return rays;
}

json kernel_statistics(const Profile &profile) {
    json kernels = json::array();
    for (const auto &[name, kernel] : profile)
        kernels.push_back({{"name", name}, {"launches", kernel.launches}, {"items", kernel.items}, {"milliseconds", kernel.milliseconds}});
    return kernels;
}

}  // namespace

json scene_contents(const Scene &scene, const CompiledScene &compiled) {
    json contents = {{"primitives", compiled.primitive_count},
                     {"triangles", 0},
                     {"lights", scene.lights.size()},
                     {"materials", scene.materials.size()},
                     {"cameras", scene.cameras.size()}};
    for (std::size_t kind = 0; kind < compiled.primitives.size(); ++kind) {
        const std::string name = compiled.primitives[kind]->name;
        contents["kinds"][name] = compiled.counts[kind];
        if (name.ends_with("triangle")) contents["triangles"] = contents["triangles"].get<std::size_t>() + compiled.counts[kind];
    }
    return contents;
}

json statistics(const RenderReport &report) {
    const FilmSettings &film = report.scene.film;
    const PhaseSeconds &s = report.seconds;
    json features = {{"used", features_in_use(report.scene, report.compiled)}, {"skipped", json::array()}};
    for (const Skipped &skipped : all_skipped(report.compiled, report.integrator))
        features["skipped"].push_back({{"name", skipped.name}, {"why", skipped.why}});
    return {{"scene", scene_contents(report.scene, report.compiled)},
            {"device", report.device.info().name},
            {"integrator", report.scene.integrator.type},
            {"accelerator", report.compiled.accelerator},
            {"width", film.width},
            {"height", film.height},
            {"spp", film.spp},
            {"seed", film.seed},
            {"seconds",
             {{"read", s.read},
              {"scene", s.scene},
              {"accelerator", s.accelerator},
              {"kernels", s.kernels},
              {"render", s.render},
              {"write", s.write},
              {"total", s.total}}},
            {"rays", ray_statistics(report.integrator.counts())},
            {"refused", report.integrator.refused()},
            {"clamped", report.clamped},
            {"kernels", kernel_statistics(report.device.profile())},
            {"memory", {{"scene_bytes", report.scene_bytes}, {"wave_bytes", report.wave_bytes}, {"film_bytes", report.film_bytes}}},
            {"features", features},
            {"warnings", report.scene.warnings}};
}

std::string explain(const Scene &scene, const CompiledScene &compiled, const Integrator &integrator) {
    std::string text;
    for (const std::string &used : features_in_use(scene, compiled)) text += "uses    " + used + "\n";
    for (const Skipped &skipped : all_skipped(compiled, integrator)) text += "skips   " + skipped.name + ": " + skipped.why + "\n";
    return text;
}

}  // namespace brandung
