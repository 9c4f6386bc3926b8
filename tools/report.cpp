#include "tools/report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "scene/accelerators/accelerator.h"
#include "scene/aovs/aov.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/filters/filter.h"
#include "scene/kinds.h"
#include "scene/lights/light.h"
#include "scene/samplers/sampler.h"
#include "tools/provenance.h"
#include "tools/report_text.h"

namespace brandung {
namespace {

using nlohmann::json;

std::vector<std::string> features_in_use(const Job &job) {
    const Scene &scene = job.scene;
    const CompiledScene &compiled = job.compiled;
    std::vector<std::string> used;
    for (const PrimitiveKind *kind : compiled.primitives) used.push_back(std::string("primitive ") + kind->name);
    for (const uint kind : compiled.bsdfs) used.push_back(std::string("material ") + bsdf_kinds()[kind].name);
    for (const uint kind : compiled.lights) used.push_back(std::string("light ") + light_kinds()[kind].name);
    if (compiled.emissive_instances) used.push_back("emissive shapes of instances as lights");
    used.push_back(fmt::format("accelerator {}{}{}", compiled.accelerator->name, quality(job) == "high" ? ", quality high" : "",
                               job.choice ? ", " + text_of(*job.choice) : ""));
    used.push_back(std::string("sampler ") + sampler_kinds()[compiled.sampler].name);
    used.push_back(fmt::format("filter {}{}", filter_kinds()[scene.film.filter].name, splats(scene.film) ? ", splatted" : ""));
    for (const uint aov : scene.film.aovs) used.push_back(std::string("AOV ") + aov_kinds()[aov].name);
    used.push_back("integrator " + scene.integrator.type);
    if (compiled.bundles) used.push_back("bundles of rays: " + text_of(scene.integrator.bundles_in_use()));
    if (compiled.instance_count > 0) used.push_back(counted(compiled.instance_count, "instance") + " of " + counted(compiled.group_count, "group"));
    const auto moving = std::ranges::count_if(scene.instances, [](const PlacedGroup &placed) { return !placed.motion.empty(); });
    if (moving > 0) used.push_back("motion of " + counted(std::size_t(moving), "instance"));
    if (!job.camera.keys.empty()) used.push_back("motion of the camera");
    if (compiled.shading_normals) used.push_back("shading normals");
    if (compiled.texture_count > 0) used.push_back(counted(compiled.texture_count, "texture"));
    if (compiled.header.vertex_colors.count > 0) used.push_back("vertex colours");
    if (compiled.header.background_texture != 0) used.push_back("picture as background");
    if (compiled.chooses) used.push_back("materials that choose among others");
    if (compiled.reflects) used.push_back("reflected rays");
    if (compiled.transmits) used.push_back(fmt::format("refracted rays, lists of {} media", compiled.interior_size));
    if (compiled.follows_one) used.push_back("random choice of reflected and refracted rays");
    if (compiled.filters_shadows) used.push_back("filtered shadows");
    return used;
}

std::string why_no_environment(const CompiledScene &compiled) {
    if (!compiled.paths) return "only paths ask for the light of a picture as background";
    return compiled.header.background_texture == 0 ? "the background is no picture" : "the picture as background is black, or no light is asked for";
}

/// Kinds that the program knows and this scene has none of.
std::vector<Skipped> kinds_not_in_use(const CompiledScene &compiled) {
    std::vector<Skipped> skipped;
    for (const PrimitiveKind *kind : primitive_kinds())
        if (std::find(compiled.primitives.begin(), compiled.primitives.end(), kind) == compiled.primitives.end())
            skipped.push_back({std::string("primitive ") + kind->name, "the scene has none"});
    if (compiled.instance_count == 0) skipped.push_back({"instances", "the scene has none"});
    if (!compiled.moves) skipped.push_back({"times of rays", "no instance moves while the shutter is open"});
    const uint environment = kind_number(light_kinds(), "environment");
    for (uint kind = 0; kind < light_kinds().size(); ++kind)
        if (std::find(compiled.lights.begin(), compiled.lights.end(), kind) == compiled.lights.end())
            skipped.push_back(
                {std::string("light ") + light_kinds()[kind].name, kind == environment ? why_no_environment(compiled) : "the scene has none"});
    if (!compiled.emissive_instances)
        skipped.push_back(
            {"emissive shapes of instances as lights", compiled.instance_count == 0 ? "the scene has no instances" : "no light is a shape of one"});
    return skipped;
}

std::vector<Skipped> all_skipped(const Job &job) {
    std::vector<Skipped> skipped = kinds_not_in_use(job.compiled);
    if (!job.aovs) skipped.push_back({"record_aov", "no AOV is asked for"});
    if (!job.renderer.filter().splats()) skipped.push_back({"add_splats", "each sample counts in its pixel alone"});
    if (!job.renderer.filter().has_weights()) skipped.push_back({"weigh_samples", "no sample has a negative weight"});
    for (const Skipped &other : job.renderer.integrator().skipped()) skipped.push_back(other);
    if (job.compiled.media > max_interior_size)
        skipped.push_back({fmt::format("more than {} media around one point", max_interior_size),
                           fmt::format("a ray's list is not longer; the scene has {} transparent materials", job.compiled.media)});
    return skipped;
}

json phases(const PhaseSeconds &seconds) {
    json phases = {
        {"read", seconds.read},     {"accelerator_choice", seconds.choice}, {"scene", seconds.scene},  {"accelerator", seconds.accelerator},
        {"device", seconds.device}, {"kernels", seconds.kernels},           {"render", seconds.render}};
    if (seconds.write) phases["write"] = *seconds.write;
    if (seconds.total) phases["total"] = *seconds.total;
    return phases;
}

/// What `auto` expects of each accelerator for this render; what it gave up has no time to trace. Null where it did not choose.
json choice(const Job &job) {
    if (!job.choice) return nullptr;
    json trials = json::array();
    for (const TriedAccelerator &trial : job.choice->trials) {
        const bool given_up = std::isinf(trial.trace_seconds);
        trials.push_back(
            {{"name", trial.kind->name}, {"build_seconds", trial.build_seconds}, {"trace_seconds", given_up ? json() : json(trial.trace_seconds)}});
    }
    return {{"rays", job.choice->rays}, {"rays_tried", job.choice->rays_tried}, {"accelerators", trials}};
}

}  // namespace

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

json scene_contents(const Scene &scene, const CompiledScene &compiled) {
    json contents = {{"primitives", compiled.primitive_count}, {"triangles", 0}, {"groups", compiled.group_count},
                     {"instances", compiled.instance_count},   {"lights", 0},    {"materials", scene.materials.size()},
                     {"cameras", scene.cameras.size()}};
    for (const auto &[name, count] : compiled.light_counts) {
        contents["light_kinds"][name] = count;
        contents["lights"] = contents["lights"].get<uint>() + count;
    }
    for (std::size_t kind = 0; kind < compiled.primitives.size(); ++kind) {
        const std::string name = compiled.primitives[kind]->name;
        contents["kinds"][name] = compiled.counts[kind];
        if (name.ends_with("triangle")) contents["triangles"] = contents["triangles"].get<std::size_t>() + compiled.counts[kind];
    }
    return contents;
}

json features(const Job &job) {
    json skipped = json::array();
    for (const Skipped &one : all_skipped(job)) skipped.push_back({{"name", one.name}, {"why", one.why}});
    json not_shown = json::array();
    for (const NotShown &one : job.renderer.integrator().not_shown()) not_shown.push_back({{"name", one.name}, {"why", one.why}});
    return {{"used", features_in_use(job)}, {"skipped", skipped}, {"not_shown", not_shown}};
}

std::string explain(const json &features) {
    std::string text;
    for (const json &used : features["used"]) text += fmt::format("uses    {}\n", used.get<std::string>());
    for (const json &skipped : features["skipped"])
        text += fmt::format("skips   {}: {}\n", skipped["name"].get<std::string>(), skipped["why"].get<std::string>());
    for (const json &hidden : features["not_shown"])
        text += fmt::format("cannot show {}: {}\n", hidden["name"].get<std::string>(), hidden["why"].get<std::string>());
    return text;
}

json quality(const Job &job) {
    if (!job.compiled.accelerator->qualities) return nullptr;
    return name_of(job.scene.accelerator_quality);
}

json memory(const Job &job) {
    return {{"scene_bytes", job.on_device.bytes()},
            {"node_bytes", job.compiled.node_bytes},
            {"block_bytes", job.compiled.block_bytes},
            {"shading_bytes", job.compiled.shading_bytes},
            {"texture_bytes", job.on_device.texture_bytes()},
            {"wave_bytes", job.renderer.wave_bytes()},
            {"film_bytes", job.film_bytes()}};
}

/// What the picture's error is beyond noise.
json biases(const Job &job) {
    json list = json::array();
    const auto add = [&](const std::string &name, const std::string &why) { list.push_back({{"name", name}, {"why", why}}); };
    const Integrator &integrator = job.renderer.integrator();
    for (const Bias &bias : integrator.biases()) add(bias.name, bias.why);
    if (const uint clamped = job.film.clamped()) add("clamping", fmt::format("{} beyond 2^16 cut", counted(clamped, "sample")));
    if (const auto refused = integrator.refused()) add("refused", fmt::format("{} that were not finite left out", counted(refused, "contribution")));
    if (const auto lost = integrator.media_lost())
        add("media", fmt::format("a ray entered more than its list has places for {}", counted(lost, "time")));
    return list;
}

json noise_statistics(const std::optional<Noise> &noise) {
    if (!noise) return nullptr;
    return {{"relmse", noise->relmse}, {"confidence_95", {noise->low, noise->high}}};
}

json statistics(const Job &job, const PhaseSeconds &seconds, const RenderEnd &end) {
    static constexpr const char *stopped_by[] = {"samples", "error", "time", "interruption", "failure"};  // by StoppedBy
    const FilmSettings &film = job.scene.film;
    const Integrator &integrator = job.renderer.integrator();
    const Window window = film.window();
    return {{"scene", scene_contents(job.scene, job.compiled)},
            {"device", job.device.info().name},
            {"distrust", job.distrust},
            {"integrator", job.scene.integrator.type},
            {"accelerator", job.compiled.accelerator->name},
            {"accelerator_quality", quality(job)},
            {"accelerator_choice", choice(job)},
            {"width", film.width},
            {"height", film.height},
            {"window", {window.left, window.top, window.right, window.bottom}},
            {"spp", end.spp},
            {"seed", film.seed},
            {"interrupted", !end.complete()},
            {"stopped_by", stopped_by[static_cast<std::size_t>(end.stopped_by)]},
            {"samples_done", end.samples_done},
            {"samples_total", end.samples_total},
            {"seconds", phases(seconds)},
            {"rays", ray_statistics(integrator.counts())},
            {"refused", integrator.refused()},
            {"media_lost", integrator.media_lost()},
            {"clamped", job.film.clamped()},
            {"noise", noise_statistics(end.noise)},
            {"biased_by", biases(job)},
            {"kernels", kernel_statistics(job.device.profile())},
            {"memory", memory(job)},
            {"features", features(job)},
            {"warnings", job.compiled.warnings},
            {"warning_places", job.compiled.warning_places}};
}

}  // namespace brandung
