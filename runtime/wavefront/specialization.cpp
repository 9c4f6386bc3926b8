#include "runtime/wavefront/specialization.h"

#include <fmt/format.h>

#include "scene/accelerators/accelerator.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/filters/filter.h"
#include "scene/lights/light.h"
#include "scene/samplers/sampler.h"

namespace brandung {
namespace {

std::string include(const std::string &file) { return "#include \"kernels/" + file + "\"\n"; }

/// One entry of a list: X(kind, Record, name).
std::string entry(std::size_t kind, const char *record, const char *name) { return fmt::format(" X({}, {}, {})", kind, record, name); }

void add_primitives(const CompiledScene &scene, Sources &sources) {
    std::string records, surfaces, hits, list;
    for (std::size_t kind = 0; kind < scene.primitives.size(); ++kind) {
        const PrimitiveKind &primitive = *scene.primitives[kind];
        records += include(fmt::format("primitives/{}.h", primitive.name));
        surfaces += include(fmt::format("primitives/{}.cl", primitive.name));
        hits += include(fmt::format("primitives/{}_hit.cl", primitive.name));
        list += entry(kind, primitive.record, primitive.name);
    }
    sources["generated/primitives.cl"] = "#pragma once\n" + records + "#define FOR_EACH_PRIMITIVE(X)" + list + "\n";
    sources["generated/primitive_surfaces.cl"] = "#pragma once\n" + surfaces;
    sources["generated/primitive_hits.cl"] = hits;
}

void add_accelerator(const CompiledScene &scene, RayLanes lanes, Sources &sources) {
    const bool scalar = lanes == RayLanes::one;
    const std::string levels = scene.instances ? "two_levels" : "one_level";
    sources["generated/accelerator.cl"] = include(fmt::format("accelerators/{}{}.cl", scene.accelerator->file, scalar ? "_scalar" : ""));
    sources["generated/single_ray.cl"] = include(scalar ? "accelerators/single_ray_x1.cl" : "accelerators/single_ray_x8.cl");
    sources["generated/levels.cl"] = include(fmt::format("accelerators/{}.cl", levels));
    sources["generated/work.cl"] = include("accelerators/no_work.cl");
    if (scene.accelerator->interleaved) {
        sources["generated/interleaved_accelerator.cl"] = include(fmt::format("accelerators/{}_interleaved.cl", scene.accelerator->file));
        sources["generated/interleaved_root.cl"] = include(fmt::format("accelerators/{}_root.cl", scene.accelerator->file));
        sources["generated/interleaved_levels.cl"] = include(fmt::format("accelerators/interleaved_{}.cl", levels));
    }
    if (!scene.accelerator->packets) return;
    sources["generated/packet_accelerator.cl"] = include(fmt::format("accelerators/{}_packets.cl", scene.accelerator->file));
    sources["generated/packet_levels.cl"] = include(fmt::format("accelerators/packet_{}.cl", levels));
}

/// The bits of those in use that are flat.
uint flat_kinds(const CompiledScene &scene) {
    uint bits = 0;
    for (std::size_t kind = 0; kind < scene.primitives.size(); ++kind) bits |= uint{scene.primitives[kind]->is_flat} << kind;
    return bits;
}

/// A family whose kinds are numbered by their place in `kinds`.
template <class Kinds>
std::string family(const std::vector<uint> &in_use, const Kinds &kinds, const std::string &folder, const std::string &list_name) {
    std::string text = "#pragma once\n", list;
    for (const uint kind : in_use) {
        text += include(fmt::format("{}/{}.cl", folder, kinds[kind].name));
        list += entry(kind, kinds[kind].record, kinds[kind].name);
    }
    return text + "#define " + list_name + "(X)" + list + "\n";
}

void add_instances(const CompiledScene &scene, bool moves, Sources &sources) {
    const char *still = scene.instances ? "primitives/instance.cl" : "primitives/no_instance.cl";
    sources["generated/instances.cl"] = include(moves ? "primitives/moving_instance.cl" : still);
    sources["generated/instance_rows.cl"] = include(moves ? "accelerators/moving_instance_rows.cl" : "accelerators/instance_rows.cl");
    sources["generated/time.cl"] = include(moves ? "core/time.cl" : "core/no_time.cl");
    sources["generated/shutter.cl"] = include(moves ? "cameras/shutter.cl" : "cameras/no_shutter.cl");
}

/// The kinds in use that Whitted's integrator can show.
std::vector<uint> whitted_bsdfs(const CompiledScene &scene) {
    std::vector<uint> kinds = scene.bsdfs;
    std::erase_if(kinds, [](uint kind) { return !bsdf_kinds()[kind].is_whitted; });
    return kinds;
}

}  // namespace

uint branching(const CompiledScene &scene) {
    if (scene.paths) return scene.bundles ? 2 : 1;
    return scene.transmits && !scene.follows_one ? 2 : scene.reflects || scene.transmits ? 1 : 0;
}

Sources specialize(const CompiledScene &scene, RayLanes lanes, Times times) {
    const bool moves = scene.moves && times == Times::of_rays;
    Sources sources;
    add_primitives(scene, sources);
    sources["generated/bsdfs.cl"] = family(scene.bsdfs, bsdf_kinds(), "bsdfs", "FOR_EACH_BSDF");
    sources["generated/whitted_bsdfs.cl"] = family(whitted_bsdfs(scene), bsdf_kinds(), "bsdfs", "FOR_EACH_WHITTED_BSDF");
    sources["generated/lights.cl"] = family(scene.lights, light_kinds(), "lights", "FOR_EACH_LIGHT");
    add_accelerator(scene, lanes, sources);
    add_instances(scene, moves, sources);
    sources["generated/emissive_instances.cl"] =
        include(scene.emissive_instances ? "lights/emissive_instances.cl" : "lights/no_emissive_instances.cl");
    sources["generated/environment.cl"] = include(scene.environment ? "lights/environment_density.cl" : "lights/no_environment.cl");
    sources["generated/sampler.cl"] = include(fmt::format("samplers/{}.cl", sampler_kinds()[scene.sampler].name));
    sources["generated/filter.cl"] = include(fmt::format("filters/{}.cl", filter_kinds()[scene.filter].file));
    sources["generated/interior.cl"] = include(scene.transmits ? "core/interior.cl" : "core/no_interior.cl");
    sources["generated/choosing.cl"] = include(scene.chooses ? "bsdfs/choosing.cl" : "bsdfs/no_choosing.cl");
    sources["generated/losses.cl"] = include(scene.losses ? "bsdfs/losses.cl" : "bsdfs/no_losses.cl");
    sources["generated/tints.cl"] = include(scene.tints ? "core/tints.cl" : "core/no_tints.cl");
    sources["generated/shadow_filter.cl"] = include(scene.filters_shadows ? "core/shadow_filter.cl" : "core/no_shadow_filter.cl");
    sources["generated/constants.h"] = fmt::format(
        "#pragma once\n#define BRANCHING {}u\n#define TRANSMITS {}\n#define FOLLOWS_ONE {}\n#define INTERIOR_SIZE {}u\n#define HIGHLIGHTS "
        "{}\n#define SHADING_NORMALS {}\n#define PATHS {}\n"
        "#define INSTANCES {}\n#define INSTANCES_MOVE {}\n#define LIGHTS {}\n#define BUNDLES {}\n#define ONE_BSDF {}\n#define CHOOSES {}\n#define "
        "FACETS {}u\n#define "
        "INSTANCE_KIND "
        "{}u\n#define FLAT_KINDS "
        "{:#x}u\n",
        branching(scene), scene.transmits ? 1 : 0, scene.follows_one ? 1 : 0, scene.interior_size, scene.highlights ? 1 : 0,
        scene.shading_normals ? 1 : 0, scene.paths ? 1 : 0, scene.instances ? 1 : 0, moves ? 1 : 0, scene.header.light_choices.count > 0 ? 1 : 0,
        scene.bundles ? 1 : 0, scene.bsdfs.size() == 1 ? 1 : 0, scene.chooses ? 1 : 0, scene.facets, scene.primitives.size(), flat_kinds(scene));
    return sources;
}

}  // namespace brandung
