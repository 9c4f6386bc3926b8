/// Rays that leave every kind of primitive: they begin on their side, near enough, and do not meet the surface where they begin.
#include <fmt/format.h>

#include "runtime/selftest/crossing_kernels.h"
#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 17;

/// As kernels/selftest/spawned_rays.cl has it.
struct SpawnResult {
    vec3 p, error, geometric, origin;
    float t;
    uint first_hit, second_hit;
};

/// Sizes about 10^-6, 1 and 10^6, at up to 2^20 times as far from the origin.
Placing scales(InputSource &source) {
    const float sizes[] = {1e-6f, 1, 1e6f};
    const int offsets[] = {2, 10, 20};
    return {sizes[source.below(3)] * source.uniform(0.5, 2), offsets[source.below(3)]};
}

class SpawnedRays final : public Subject {
public:
    SpawnedRays(Device &device, const PrimitiveOracle &oracle)
        : device_(device), oracle_(oracle), kernel_(device, "kernels/selftest/spawned_rays.cl", "test_spawned_rays", one_kind(oracle.kind())) {}

    Findings examine(uint round) override {
        const CrossingCases cases = make_cases(oracle_, inputs_per_round, seed_of(3, round, 0), scales, meeting_ray);
        const std::vector<vec3> directions = make_directions(round);
        const std::vector<SpawnResult> results = run(cases, directions);
        return examine_each(cases.rays.size(), [&](std::size_t i, Findings &findings) {
            if (results[i].first_hit) look_at(cases, i, results[i], directions[i], round, findings);
        });
    }

private:
    static std::vector<vec3> make_directions(uint round) {
        std::vector<vec3> directions(inputs_per_round);
        for_parts(inputs_per_round, [&](std::size_t first, std::size_t last) {
            InputSource source(seed_of(4, round, first));
            for (std::size_t i = first; i < last; ++i) directions[i] = source.direction();
        });
        return directions;
    }

    std::vector<SpawnResult> run(const CrossingCases &cases, const std::vector<vec3> &directions) {
        Buffer<SpawnResult> results(device_, cases.rays.size());
        results.fill_zero();
        kernel_(cases.rays.size(), NormalsOnly(device_, cases), Buffer<std::byte>(device_, cases.blocks),
                Buffer<ShadingRecord>(device_, cases.records), Buffer<float>(device_, cases.extents), Buffer<Ray>(device_, cases.rays),
                Buffer<vec3>(device_, directions), static_cast<uint>(cases.rays.size()), results);
        std::vector<SpawnResult> read = results.read();
        device_.finish();
        return read;
    }

    /// The stated bound: a ray begins no further from the surface than twice the point's own, and the rounding of its coordinates; so it passes by
    /// nothing that is further away.
    static double farthest(const SpawnResult &result) {
        const vec3 n = glm::abs(result.geometric);
        return 2 * double(dot(Vector(n), Vector(result.error))) + 4 * unit_roundoff * double(dot(Vector(n), Vector(glm::abs(result.origin)))) +
               0x1p-147;
    }

    /// Whether every coordinate has been moved by the normal times the point's bound, or more: rounding may only take the ray away.
    static bool is_moved(const SpawnResult &result, vec3 direction) {
        const Vector n = result.geometric;
        const extended length = dot(Vector(glm::abs(result.geometric)), Vector(result.error)) * (1 - 8 * unit_roundoff);
        const bool with_normal = glm::dot(glm::dvec3(result.geometric), glm::dvec3(direction)) >= 0;
        const Vector moved = (Vector(result.origin) - Vector(result.p)) * (with_normal ? 1 : -1);
        const auto far_enough = [&](extended n, extended moved) { return n < 0 ? moved <= n * length : moved >= n * length; };
        return far_enough(n.x, moved.x) && far_enough(n.y, moved.y) && far_enough(n.z, moved.z);
    }

    void look_at(const CrossingCases &cases, std::size_t i, const SpawnResult &result, vec3 direction, uint round, Findings &findings) const {
        const Lane lane = cases.lane(i);
        const auto blame = [&](const std::string &what) {
            findings.blame([&] {
                return fmt::format("{}; at {} +- {}, normal {}, origin {}, towards {}{}", what, text_of(result.p), text_of(result.error),
                                   text_of(result.geometric), text_of(result.origin), text_of(direction), describe_case(cases, i, round));
            });
        };
        const Normal normal = oracle_.normal_at(lane, result.p);
        const extended cosine = dot(normal.n, Vector(direction));
        const double height = double(oracle_.distance(lane, result.origin)) * (cosine < 0 ? -1 : 1), bound = farthest(result);
        if (absolute(cosine) <= normal.error || oracle_.room(lane, result.p) < 16 * bound) {
            ++findings.ambiguous;  // as far as floats can tell, there is no side, or nothing beyond the surface
            return;
        }
        ++findings.hits;
        // A point that is exact, as on a plane through the origin across an axis, need not be moved.
        const bool exact = dot(Vector(glm::abs(result.geometric)), Vector(result.error)) == 0;
        if (!(height > 0 || (exact && height == 0))) return blame(fmt::format("begins {:.3g} on the other side", -height));
        findings.measure(Quantity::offset, height, bound, ulp_of(largest(Vector(result.origin))), double(largest(Vector(result.origin))),
                         [&] { return fmt::format("begins {:.3g} away, more than {:.3g}{}", height, bound, describe_case(cases, i, round)); });
        if (!is_moved(result, direction)) return blame("moved by less than the point's bound");
        const Ray next = {result.origin, INFINITY, direction, RAY_TAG(RAY_REFLECTED, NO_HIT)};
        const std::vector<Root> roots = oracle_.roots(lane, next);
        const Verdict verdict = judge(roots, {result.second_hit != 0, result.t}, INFINITY);
        if (!verdict.fault.empty()) return blame(verdict.fault);
        if (result.second_hit && verdict.nearest <= 0) return blame(fmt::format("meets its own surface at t = {:.9g}", result.t));
    }

    Device &device_;
    const PrimitiveOracle &oracle_;
    Kernel kernel_;
};

}  // namespace

void add_spawned_rays(std::vector<SubjectEntry> &list) {
    for (const PrimitiveOracle *oracle : primitive_oracles()) {
        const std::string name = oracle->kind().name;
        list.push_back({"spawn_" + name, "core/spawn.cl, primitives/" + name + ".cl, " + name + "_hit.cl",
                        "offset: twice the surface's own error; never their own surface", 8,
                        [oracle](Device &device) { return std::make_unique<SpawnedRays>(device, *oracle); }});
    }
}

}  // namespace brandung
