/// Shapes that shine, of every kind of primitive, in the world and in instances: rays to them end just before their surface, and the light that comes
/// from there is that of the point, by the density with which it is chosen.
#include <fmt/format.h>

#include <cstring>

#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended_map.h"
#include "runtime/selftest/light_kernel.h"
#include "runtime/selftest/oracle.h"
#include "runtime/selftest/subjects/list.h"
#include "scene/transform.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 16;

/// Shapes, each of them in a block of its own, and what lights what.
struct EmissiveCases {
    std::size_t block_bytes;
    std::vector<std::byte> blocks;
    std::vector<float> extents;  ///< largest magnitude of a coordinate of the shape's bounds
    std::vector<uint> rows;      ///< whose square is how many parts the light has
    LitPoints lit;
    Lane lane(std::size_t i) const { return {blocks.data() + i * block_bytes, 0}; }
};

/// Of shapes about so large.
TransformPair any_transforms(InputSource &source, float size) {
    for (;;) {
        const auto factor = [&] { return double(source.sign()) * source.power_of_two(-3, 3); };
        const AffineMap turn = rotation(source.uniform(-180, 180), glm::dvec3(source.direction()));
        const AffineMap map = then(then(turn, scaling({factor(), factor(), factor()})),
                                   translation(glm::dvec3(source.direction()) * double(size * source.power_of_two(-10, 14))));
        if (const auto transforms = make_transforms(map)) return *transforms;
    }
}

/// A shape, and a point that it lights: near and far, inside, and on it.
void add_case(const PrimitiveOracle &oracle, InputSource &source, EmissiveCases &cases) {
    const float sizes[] = {1e-6f, 1, 1e6f}, size = sizes[source.below(3)] * source.uniform(0.5, 2);
    std::unique_ptr<Shape> shape;
    while (!shape) shape = oracle.make(source, source.one_in(4) ? vec3(0) : source.direction() * (size * source.power_of_two(-2, 16)), size);
    const std::size_t i = cases.extents.size();
    shape->write_lane(0, 0, cases.blocks.data() + i * cases.block_bytes);
    const Bounds bounds = shape->bounds(0);
    const vec3 far = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    cases.extents.push_back(std::max({far.x, far.y, far.z}));

    const Aim aim = oracle.aim(source, cases.lane(i));
    const vec3 offsets[] = {source.direction() * (size * source.power_of_two(-8, 12)), aim.normal * (-size * source.uniform(0, 1)), vec3(0)};
    vec3 p = aim.point + offsets[source.one_in(16) ? 2 : source.below(2)];
    Instance &instance = cases.lit.instances.emplace_back();
    const uint number = source.one_in(2) ? uint(i + 1) : 0;
    const TransformPair transforms = any_transforms(source, size);
    instance.to_world = transforms.to_world, instance.to_group = transforms.to_group;
    if (number != 0) {
        const Transform &m = transforms.to_world;
        p = vec3(glm::dmat3(m.x, m.y, m.z) * glm::dvec3(p) + glm::dvec3(m.origin));
    }
    cases.rows.push_back(source.one_in(2) ? 1 : 1 + source.below(8));
    const std::vector<Light> cells = shape->light(cases.rows.back(), cases.lit.faces);
    Material shining{};
    shining.emission = Spectrum(1);
    append_cells({cells[source.below(uint(cells.size()))]}, shining, number, cases.lit.lights);
    cases.lit.points.push_back(p), cases.lit.branches.push_back(static_cast<uint>(source.bits() >> 32));
}

EmissiveCases make_cases(const PrimitiveOracle &oracle, std::uint64_t seed) {
    EmissiveCases cases{oracle.kind().block_bytes, std::vector<std::byte>(oracle.kind().block_bytes * inputs_per_round), {}, {}, {}};
    InputSource source(seed);
    while (cases.extents.size() < inputs_per_round) add_case(oracle, source, cases);
    return cases;
}

/// A point of the surface in the world, its normal, which leads to the lit point, and how far rounding takes the kernel's from both.
struct Shining {
    Vector p, normal;
    extended across;  ///< of the ray's end, off the surface: on purpose, by bounds that hold for all points
    extended along;   ///< of the point, in all directions, by rounding
    extended turned;  ///< of the normal
    extended height;  ///< of the lit point above it
    extended beyond;  ///< how far the ray's end is from the surface, on that side
    Density density;
};

/// Where a ray ends near a surface: off it by 2^-20 of the coordinates that its point is made of, of which there are up to 5 extents, and by 2^-20 of
/// the ray's length and of the point's coordinates, so by no more than 5/8 of 2^-17 and 2^-18 of these, and by rounding. With u = 2^-24 that is 16 u
/// of the extent in the shape's own space: worst is the frustum's, 2 u of half its length, 7 u of a radius (of a unit vector, a product, and sums)
/// and u of the sum, where lengths are up to 1.8 extents and radii up to 1.3; 4 u of terms on the way to the world; and 8 u of the ray's length: 2 u
/// of the difference of its ends and 6 u of its own length and direction, by which the end that they say lies elsewhere.
/// What its end is off by, it makes larger on a surface that bends towards it: as it is the nearer, the more of the room it takes.
class ShiningPoint {
public:
    ShiningPoint(const PrimitiveOracle &oracle, Lane lane, float extent, const Instance *instance)
        : oracle_(oracle), lane_(lane), own_slack_(0x1p-17 * extent), own_rounding_(0x1p-20 * extent), instance_(instance) {}

    Shining at(Vector end, Vector lit) const { return instance_ ? in_instance(end, lit) : in_world(end, lit); }

private:
    static extended end_slack(Vector end, Vector lit) { return 0x1p-18 * (length(end - lit) + largest(end)); }
    static extended end_rounding(Vector end, Vector lit) { return 8 * unit_roundoff * length(end - lit); }

    /// How far the foot of a point moves with it, where it takes so large a part of the room.
    static extended moved_foot(extended moved, extended part) { return part < 0.5 ? moved / (1 - part) : extended(HUGE_VAL); }

    Shining in_world(Vector end, Vector lit) const {
        const extended slack = own_slack_ + end_slack(end, lit), off = oracle_.distance(lane_, end);
        const Normal normal = oracle_.normal_at(lane_, end);
        const Vector p = end - normal.n * off;
        const extended rounding = moved_foot(own_rounding_ + end_rounding(end, lit), absolute(off) / oracle_.room(lane_, p));
        const extended height = dot(normal.n, lit - p), side = height < 0 ? -1 : 1;
        return {p,
                normal.n * side,
                slack,
                rounding,
                normal.error + rounding / oracle_.room(lane_, p),
                absolute(height),
                off * side,
                oracle_.inverse_density(lane_, p, lit, rounding, 0x1p-22 * largest(lit))};
    }

    /// By the map: planes at distance 1 are 1 / |M⁻ᵀ n| apart there, areas are larger by det M |M⁻ᵀ n|. Its own roundings are those of points on
    /// their way out, and of rays on their way in.
    Shining in_instance(Vector end, Vector lit) const {
        const ExtendedMap to_world(instance_->to_world), to_group(instance_->to_group);
        const Foot foot = foot_of(end, to_world);
        const auto &[p, own, normal, apart] = foot;
        const Vector there = to_world.point_back(p), back = to_group.point_of_magnitudes(magnitude(end) + magnitude(end - lit)) * 0x1p-18;
        const Vector out = to_world.point_of_magnitudes(magnitude(there)) * 0x1p-19;
        const extended slack = apart * (own_slack_ + dot(magnitude(own.n), back)) + dot(magnitude(normal), out) + end_slack(end, lit);
        const Vector ones(1, 1, 1);
        const extended on_the_way = 0x1p-3 * length(out) + end_rounding(end, lit);
        const extended scale = length(to_group.direction_of_magnitudes(ones)), off = dot(normal, end - p);
        const extended along = moved_foot(length(to_world.direction_of_magnitudes(ones)) * own_rounding_ + on_the_way,
                                          absolute(off) * scale * scale * apart / oracle_.room(lane_, there));
        const extended own_along = own_rounding_ + scale * along;
        const extended height = dot(normal, lit - p), side = height < 0 ? -1 : 1;
        const extended turned = own.error + own_along / oracle_.room(lane_, there);
        const extended rounding = length(to_group.normal_of_magnitudes(magnitude(own.n))) * apart * (8 * unit_roundoff + 2 * turned);
        Density density = oracle_.inverse_density(lane_, there, to_world.point_back(lit), own_along, 0x1p-3 * length(back));
        density.inverse = density.inverse * absolute(to_world.determinant()) / apart, density.error = density.error + 4 * rounding;
        return {p, normal * side, slack, along, rounding, absolute(height), off * side, density};
    }

    /// The point of the surface from which the normal in the world leads to the ray's end, the normal in the shape's own space and in the world, and
    /// how far apart planes are there. The normal depends on the point: each step makes what is missing smaller by about the part that the end is of
    /// the room.
    struct Foot {
        Vector p;
        Normal own;
        Vector normal;
        extended apart;
    };
    static constexpr int most_steps = 40;
    Foot foot_of(Vector end, const ExtendedMap &to_world) const {
        Foot foot = foot_at(end, to_world);
        for (int step = 0; step < most_steps; ++step) {
            const extended missing = oracle_.distance(lane_, to_world.point_back(foot.p)) * foot.apart;
            const Foot next = foot_at(end - foot.normal * (dot(foot.normal, end - foot.p) + missing), to_world);
            const extended moved = length(next.p - foot.p);
            foot = next;
            if (moved <= 0x1p-40 * largest(end)) return foot;
        }
        foot.own.error = 1;  // there is none, or rounding alone tells which
        return foot;
    }
    Foot foot_at(Vector p, const ExtendedMap &to_world) const {
        const Normal own = oracle_.normal_at(lane_, to_world.point_back(p));
        const Vector across = to_world.normal(own.n);
        return {p, own, across * (1 / length(across)), 1 / length(across)};
    }

    const PrimitiveOracle &oracle_;
    Lane lane_;
    extended own_slack_, own_rounding_;
    const Instance *instance_;
};

class EmissiveShape final : public Subject {
public:
    EmissiveShape(Device &device, const PrimitiveOracle &oracle) : oracle_(oracle), kernel_(device) {}

    Findings examine(uint round) override {
        const EmissiveCases cases = make_cases(oracle_, seed_of(11, round, 0));
        const std::vector<LightSample> samples = kernel_(cases.lit);
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) { look_at(cases, i, samples[i], round, findings); });
    }

private:
    static const Instance *instance_of(const EmissiveCases &cases, std::size_t i) {
        Emission emission;
        std::memcpy(&emission, cases.lit.lights[i].words, sizeof emission);
        return emission.instance == 0 ? nullptr : &cases.lit.instances[emission.instance];
    }

    void look_at(const EmissiveCases &cases, std::size_t i, const LightSample &sample, uint round, Findings &findings) const {
        const vec3 lit = cases.lit.points[i];
        const auto describe = [&](const std::string &what) {
            return [&, what] { return fmt::format("{}; round {}, input {}: at {}", what, round, i, text_of(lit)); };
        };
        const Instance *instance = instance_of(cases, i);
        const Vector end = Vector(lit) + Vector(sample.ray_direction) * sample.distance;
        if (!is_finite(largest(end)) || !(sample.irradiance.x >= 0)) return findings.blame(describe("not finite"));
        const Shining shining = ShiningPoint(oracle_, cases.lane(i), cases.extents[i], instance).at(end, lit);
        const extended slack = shining.across;
        if (absolute(shining.height) <= slack || !(shining.turned < 0x1p-5)) {
            ++findings.ambiguous;  // whether it is above the surface, as far as floats can tell
            return;
        }
        ++findings.hits;
        if (!(sample.irradiance.x > 0)) return findings.blame(describe("nothing is sent"));
        findings.measure(Quantity::offset, double(absolute(shining.beyond)), double(2 * slack), ulp_of(largest(end)), double(largest(end)),
                         describe("the ray ends elsewhere"));
        if (!(shining.beyond > 0)) findings.blame(describe(fmt::format("the ray ends {:.3g} behind the surface", double(-shining.beyond))));
        look_at_ends(cases, i, end, shining, instance, findings, describe);
        look_at_irradiance(cases, i, sample, shining, lit, findings, describe);
    }

    template <class Describe>
    void look_at_ends(const EmissiveCases &cases, std::size_t i, Vector end, const Shining &shining, const Instance *instance, Findings &findings,
                      Describe describe) const {
        const Vector own = instance ? ExtendedMap(instance->to_world).point_back(end) : end;
        const extended scale = instance ? length(ExtendedMap(instance->to_group).direction_of_magnitudes(Vector(1, 1, 1))) : extended(1);
        const extended beyond = oracle_.beyond_ends(cases.lane(i), own);
        if (beyond > 2 * scale * (shining.across + shining.along)) findings.blame(describe(fmt::format("{:.3g} beyond the ends", double(beyond))));
    }

    /// Of radiance 1: the cosine at the light over the squared distance and the density. The point may be off in all directions, which counts twice
    /// in the distance, and turns the cosine as the normal's error does.
    template <class Describe>
    static void look_at_irradiance(const EmissiveCases &cases, std::size_t i, const LightSample &sample, const Shining &shining, vec3 lit,
                                   Findings &findings, Describe describe) {
        const Vector way = shining.p - Vector(lit);
        const extended r = length(way), cosine = shining.height / r, off = shining.along / r;
        const extended relative = 2 * off + (off + shining.turned) / cosine + shining.density.error + 24 * unit_roundoff;
        if (!(relative < 0.25)) return findings.leave_out(Quantity::value), findings.leave_out(Quantity::normal);
        const double exact = double(shining.density.inverse * cosine / (r * r)) / (double(cases.rows[i]) * cases.rows[i]);
        findings.measure(Quantity::value, std::abs(sample.irradiance.x - exact), double(relative) * exact, ulp_of(exact), exact,
                         describe(fmt::format("irradiance {:.9g}, and not {:.9g}", sample.irradiance.x, exact)));
        const double turned = double(length(Vector(sample.direction) - unit(way)));
        findings.measure(Quantity::normal, turned, double(off) + 8 * unit_roundoff, 2 * unit_roundoff, 1, describe("the direction is off"));
    }

    const PrimitiveOracle &oracle_;
    LightKernel kernel_;
};

}  // namespace

void add_emissive_shapes(std::vector<SubjectEntry> &list) {
    for (const PrimitiveOracle *oracle : primitive_oracles()) {
        const std::string name = oracle->kind().name;
        list.push_back({"emissive_" + name, "lights/emission.cl, emissive_*.cl",
                        "rays end before the surface, by twice the point's own error; value: the conditioning of that", 2,
                        [oracle](Device &device) { return std::make_unique<EmissiveShape>(device, *oracle); }});
    }
}

}  // namespace brandung
