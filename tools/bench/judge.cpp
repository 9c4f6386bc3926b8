#include "tools/bench/judge.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "tools/bench/covers.h"

namespace brandung {

/// What a ray may meet, and what it must.
struct Judge::Findings {
    std::vector<Crossing> crossings;
    double end = std::numeric_limits<double>::infinity();  ///< t at which every tracer has met something

    bool may_be_first(const Claim &claim) const {
        return std::ranges::any_of(crossings, [&](const Crossing &c) {
            return c.primitive == claim.primitive && c.instance == claim.instance && c.first <= double(claim.t) && double(claim.t) <= c.last &&
                   c.first <= end;
        });
    }
    bool is_wrong(bool any, const Claim &claim) const {
        if (!claim.meets) return end < std::numeric_limits<double>::infinity();
        return any ? crossings.empty() : !may_be_first(claim);
    }
};

Judge::Judge(const SceneGeometry &geometry) : geometry_(geometry) {
    for (const GeometrySpace &space : geometry.spaces) trees_.emplace_back(geometry, space);
}

Judge::Findings Judge::findings(const Ray &ray) const {
    Findings all;
    const std::size_t places = std::max<std::size_t>(1, geometry_.instances.size());
    for (uint instance = 0; instance < places; ++instance) {
        const RayInSpace here = instance == 0 ? ray_in_world(ray) : ray_in_group(ray, geometry_.instances[instance].to_group);
        std::vector<Crossing> crossings;
        trees_[geometry_.space_of(instance)].add_crossings_of(crossings, here, instance, all.end);
        for (const double last : covers(here, geometry_, crossings)) all.end = std::min(all.end, last);
        all.crossings.insert(all.crossings.end(), crossings.begin(), crossings.end());
    }
    return all;
}

std::vector<DisputeVerdict> Judge::judge(std::span<const Dispute> disputes) const {
    std::vector<DisputeVerdict> verdicts(disputes.size());
    tbb::parallel_for(std::size_t{0}, disputes.size(), [&](std::size_t i) {
        const Dispute &dispute = disputes[i];
        const Findings found = findings(dispute.ray);
        verdicts[i] = {found.is_wrong(dispute.any, dispute.ours), found.is_wrong(dispute.any, dispute.theirs)};
    });
    return verdicts;
}

}  // namespace brandung
