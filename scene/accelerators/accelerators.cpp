/// THE list of accelerators.
#include <fmt/format.h>

#include "scene/accelerators/accelerator.h"
#include "scene/error.h"

namespace brandung {

BuiltAccelerator build_wide_bvh(std::span<const Reference> references, const Hulls &hulls, BuildQuality quality, BuildProgress &progress);
BuiltAccelerator build_uniform_grid(std::span<const Reference> references, const Hulls &hulls, BuildQuality quality, BuildProgress &progress);
BuiltAccelerator build_octree(std::span<const Reference> references, const Hulls &hulls, BuildQuality quality, BuildProgress &progress);
BuiltAccelerator build_kd_tree(std::span<const Reference> references, const Hulls &hulls, BuildQuality quality, BuildProgress &progress);
BuiltAccelerator build_kd_tree_median(std::span<const Reference> references, const Hulls &hulls, BuildQuality quality, BuildProgress &progress);
BuiltAccelerator build_bounding_volumes(std::span<const Reference> references, const Hulls &hulls, BuildQuality quality, BuildProgress &progress);
BuiltAccelerator build_none(std::span<const Reference> references, const Hulls &hulls, BuildQuality quality, BuildProgress &progress);

const std::vector<AcceleratorKind> &accelerator_kinds() {
    static const std::vector<AcceleratorKind> kinds = {
        {"wide_bvh", "wide_bvh", true, true, true, true, true, build_wide_bvh},  // the default
        {"uniform_grid", "uniform_grid", false, false, false, false, false, build_uniform_grid},
        {"octree", "octree", false, false, false, false, false, build_octree},
        {"kd_tree", "kd_tree", false, false, false, false, false, build_kd_tree},
        {"kd_tree_median", "kd_tree", false, false, false, false, false, build_kd_tree_median},
        {"bounding_volumes", "bounding_volumes", false, false, false, false, false, build_bounding_volumes},
        {"none", "none", true, false, false, true, false, build_none},
    };
    return kinds;
}

const AcceleratorKind &find_accelerator(const std::string &name) {
    const std::vector<AcceleratorKind> &kinds = accelerator_kinds();
    std::string known = "auto";
    for (const AcceleratorKind &kind : kinds) {
        if (name == kind.name) return kind;
        known += fmt::format(", {}", kind.name);
    }
    if (name == "auto") return kinds.front();
    throw SceneError(fmt::format("accelerator \"{}\" is not known; known are: {}", name, known));
}

}  // namespace brandung
