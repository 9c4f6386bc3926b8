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

TransformPair any_transforms(InputSource &source) {
    for (;;) {
        const auto factor = [&] { return double(source.sign()) * source.power_of_two(-3, 3); };
        const AffineMap turn = rotation(source.uniform(-180, 180), glm::dvec3(source.direction()));
        const AffineMap map = then(then(turn, scaling({factor(), factor(), factor()})),
                                   translation(glm::dvec3(source.direction()) * double(source.power_of_two(-10, 10))));
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
    const TransformPair transforms = any_transforms(source);
    instance.to_world = transforms.to_world, instance.to_group = transforms.to_group;
    if (number != 0) {
        const Transform &m = transforms.to_world;
        p = vec3(glm::dmat3(m.x, m.y, m.z) * glm::dvec3(p) + glm::dvec3(m.origin));
    }
    cases.rows.push_back(source.one_in(2) ? 1 : 1 + source.below(8));
    const std::vector<Light> cells = shape->light(cases.rows.back(), cases.lit.faces);
    append_cells({cells[source.below(uint(cells.size()))]}, Spectrum(1), number, cases.lit.lights);
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
    extended across, along;  ///< of the point, across the surface and in all directions
    extended turned;         ///< of the normal
    extended height;         ///< of the lit point above it
    extended beyond;         ///< how far the ray's end is from the surface, on that side
    Density density;
};

/// Where a ray ends near a surface. The kernels' points are off by 2^-20 of the coordinates that they are made of, of which there are up to 5
/// extents; rays end off the surface by as much again, and by 2^-20 of their length and of the point's coordinates.
class ShiningPoint {
public:
    ShiningPoint(const PrimitiveOracle &oracle, Lane lane, float extent, const Instance *instance)
        : oracle_(oracle), lane_(lane), own_slack_(0x1p-17 * extent), instance_(instance) {}

    Shining at(Vector end, Vector lit) const { return instance_ ? in_instance(end, lit) : in_world(end, lit); }

private:
    static extended end_slack(Vector end, Vector lit) { return 0x1p-18 * (length(end - lit) + largest(end)); }

    Shining in_world(Vector end, Vector lit) const {
        const extended slack = own_slack_ + end_slack(end, lit), off = oracle_.distance(lane_, end);
        const Normal normal = oracle_.normal_at(lane_, end);
        const Vector p = end - normal.n * off;
        const extended height = dot(normal.n, lit - p), side = height < 0 ? -1 : 1;
        return {p,
                normal.n * side,
                slack,
                slack,
                normal.error + slack / oracle_.room(lane_, p),
                absolute(height),
                off * side,
                oracle_.inverse_density(lane_, p, lit, slack, 0x1p-22 * largest(lit))};
    }

    /// By the map: planes at distance 1 are 1 / |M⁻ᵀ n| apart there, areas are larger by det M |M⁻ᵀ n|. Its own roundings are those of points on
    /// their way out, and of rays on their way in. What the ray ends off the surface in the world is aslant in the shape's own space.
    Shining in_instance(Vector end, Vector lit) const {
        const ExtendedMap to_world(instance_->to_world), to_group(instance_->to_group);
        const Vector end_there = to_world.point_back(end), lit_there = to_world.point_back(lit);
        const Vector back = to_group.point_of_magnitudes(magnitude(end) + magnitude(end - lit)) * 0x1p-18;
        const Vector there = to_world.point_of_magnitudes(magnitude(end_there)) * 0x1p-19;
        const Normal own = oracle_.normal_at(lane_, end_there);
        const Vector across = to_world.normal(own.n);
        const extended apart = 1 / length(across), off = oracle_.distance(lane_, end_there) * apart;
        const Vector normal = across * apart, p = end - normal * off;
        const extended slack = apart * (own_slack_ + dot(magnitude(own.n), back)) + dot(magnitude(normal), there) + end_slack(end, lit);
        const extended along = length(to_world.direction_of_magnitudes(Vector(1, 1, 1) * own_slack_ + back)) + length(there) + end_slack(end, lit);
        const extended own_along = own_slack_ + length(back) + length(to_group.direction_of_magnitudes(Vector(1, 1, 1))) * slack;
        const extended height = dot(normal, lit - p), side = height < 0 ? -1 : 1, turned = own.error + own_along / oracle_.room(lane_, end_there);
        const extended rounding = length(to_group.normal_of_magnitudes(magnitude(own.n))) * apart * (8 * unit_roundoff + 2 * turned);
        Density density = oracle_.inverse_density(lane_, to_world.point_back(p), lit_there, own_along, 0x1p-3 * length(back));
        density.inverse = density.inverse * absolute(to_world.determinant()) / apart, density.error = density.error + 4 * rounding;
        return {p, normal * side, slack, along, rounding, absolute(height), off * side, density};
    }

    const PrimitiveOracle &oracle_;
    Lane lane_;
    extended own_slack_;
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
        if (absolute(shining.height) <= 4 * slack || !(shining.turned < 0x1p-5)) {
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
        findings.measure(Quantity::normal, turned, double(2 * off) + 8 * unit_roundoff, 2 * unit_roundoff, 1, describe("the direction is off"));
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
