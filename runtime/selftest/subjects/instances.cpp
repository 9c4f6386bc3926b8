/// Instances: rays on their way into a group's space, surfaces on their way out, and the boxes in the world that rays must enter first.
#include <fmt/format.h>

#include "kernels/core/items.h"
#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended_map.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/precision.h"
#include "runtime/selftest/subjects/list.h"
#include "scene/transform.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 16;

/// Records as kernels have them, in float or in double.
template <class Number> struct InstanceOf {
    Number to_world[12], to_group[12];
    uint group, material, spare[6];
};
template <class Number> struct RayOf {
    Number origin[3], t_max, direction[3];
    uint tag;
};
template <class Number> struct SurfaceOf { Number p[3], error[3], geometric[3], normal[3], lift[3]; };
template <class Number> struct InstanceResult {
    Number origin[3], direction[3];
    SurfaceOf<Number> world;
    Number back[3];
};

struct Case {
    TransformPair transforms;
    vec3 origin, direction;           ///< of a ray in the world
    vec3 p, error, geometric, shown;  ///< of a surface in the group; the last is its shading normal
    Bounds box;                       ///< of the group
};

glm::dmat3 turned(InputSource &source) { return rotation(source.uniform(-180, 180), glm::dvec3(source.direction())).linear; }

/// Rigid, scaled, mirrored, sheared, all but flat; far away at times.
AffineMap any_map(InputSource &source, float scale) {
    const auto factor = [&] { return double(source.sign()) * source.power_of_two(-6, 6); };
    AffineMap map;
    switch (source.below(4)) {
        case 0:
            map.linear = turned(source);
            break;
        case 1:
            map = scaling({factor(), factor(), factor()});
            break;
        case 2:
            map.linear = turned(source) * scaling({factor(), factor(), factor()}).linear * turned(source);
            break;
        default:
            for (int column = 0; column < 3; ++column) map.linear[column] = glm::dvec3(source.direction());
            map.linear[2] =
                glm::mix(map.linear[0], map.linear[1], source.unit()) + glm::dvec3(source.direction()) * double(source.power_of_two(-30, 0));
    }
    map.linear *= double(scale);
    map.offset = glm::dvec3(source.one_in(4) ? vec3(0) : source.direction() * (scale * source.power_of_two(-4, 20)));
    return map;
}

vec3 any_normal(InputSource &source) {
    vec3 n = source.direction();
    if (source.one_in(4)) n = vec3(0), n[int(source.below(3))] = source.sign();
    return n;
}

/// Rays begin about the surface of the box, where rounding decides whether they are in it.
Case any_case(InputSource &source) {
    Case one;
    for (;;) {
        const auto transforms = make_transforms(any_map(source, source.power_of_two(-20, 20)));
        if (!transforms) continue;
        one.transforms = *transforms;
        break;
    }
    const float size = source.power_of_two(-20, 20);
    one.p = source.direction() * size;
    one.error = glm::abs(one.p) * 0x1p-22f * (source.one_in(4) ? 0.0f : source.uniform(0, 4));
    one.geometric = any_normal(source), one.shown = any_normal(source);
    if (glm::dot(glm::dvec3(one.shown), glm::dvec3(one.geometric)) < 0) one.shown = -one.shown;
    const vec3 half = glm::abs(source.in_cube(size));
    one.box.add(one.p - half), one.box.add(one.p + half);
    vec3 place;
    for (int axis = 0; axis < 3; ++axis) {
        const float ends[] = {one.box.low[axis], one.box.high[axis], one.p[axis]};
        place[axis] = ends[source.below(3)];
    }
    const Transform &m = one.transforms.to_world;
    one.origin = vec3(glm::dmat3(m.x, m.y, m.z) * glm::dvec3(place) + glm::dvec3(m.origin));
    for (int axis = 0; axis < 3; ++axis) one.origin[axis] *= 1 + float(int(source.below(17)) - 8) * 0x1p-23f;
    one.direction = any_normal(source);
    return one;
}

template <class Number> void copy(vec3 v, Number (&to)[3]) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }
template <class Number> void copy(const Transform &m, Number (&to)[12]) {
    const vec3 columns[] = {m.x, m.y, m.z, m.origin};
    for (int i = 0; i < 12; ++i) to[i] = columns[i / 3][i % 3];
}
template <class Number> Vector wide(const Number (&v)[3]) { return {v[0], v[1], v[2]}; }
bool holds(const Bounds &box, Vector p) {
    const auto between = [](extended low, extended x, extended high) { return low <= x && x <= high; };
    return between(box.low.x, p.x, box.high.x) && between(box.low.y, p.y, box.high.y) && between(box.low.z, p.z, box.high.z);
}
extended part(Vector v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// How far the direction of a sum turns whose parts are off by up to `off`, and by unit().
double turn_of(Vector sum, Vector off) { return double(2 * length(off) / length(sum)) + 4 * unit_roundoff; }

class Instances final : public Subject {
public:
    explicit Instances(Device &device)
        : device_(device),
          kernel_(device, "kernels/selftest/instances.cl", "test_instances",
                  {{"generated/constants.h", "#pragma once\n#define INTERIOR_SIZE 0u\n#define INSTANCES 1\n"}}) {}

    Findings examine(uint round) override {
        std::vector<Case> cases(inputs_per_round);
        for_parts(inputs_per_round, [&](std::size_t first, std::size_t last) {
            InputSource source(seed_of(9, round, first));
            for (std::size_t i = first; i < last; ++i) cases[i] = any_case(source);
        });
        const auto results = run<float>(kernel_.in_float, cases);
        const auto doubles = kernel_.in_double ? run<double>(*kernel_.in_double, cases) : std::vector<InstanceResult<double>>();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) {
            look_at(cases[i], results[i], findings);
            if (kernel_.in_double) compare(cases[i], results[i], doubles[i], findings);
        });
    }

private:
    template <class Number> std::vector<InstanceResult<Number>> run(Kernel &kernel, const std::vector<Case> &cases) {
        std::vector<InstanceOf<Number>> instances(1 + cases.size());
        std::vector<RayOf<Number>> rays(cases.size());
        std::vector<SurfaceOf<Number>> surfaces(cases.size());
        for_parts(cases.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const Case &one = cases[i];
                copy(one.transforms.to_world, instances[i + 1].to_world), copy(one.transforms.to_group, instances[i + 1].to_group);
                copy(one.origin, rays[i].origin), copy(one.direction, rays[i].direction);
                copy(one.p, surfaces[i].p), copy(one.error, surfaces[i].error);
                copy(one.geometric, surfaces[i].geometric), copy(one.shown, surfaces[i].normal);
            }
        });
        Buffer<InstanceResult<Number>> results(device_, cases.size());
        kernel(cases.size(), empty_header(device_), Buffer<InstanceOf<Number>>(device_, instances), Buffer<RayOf<Number>>(device_, rays),
               Buffer<SurfaceOf<Number>>(device_, surfaces), static_cast<uint>(cases.size()), results);
        return results.read();
    }

    static std::string text_of_case(const Case &one) {
        const auto text = [](const Transform &m) {
            return brandung::text_of(m.x) + brandung::text_of(m.y) + brandung::text_of(m.z) + brandung::text_of(m.origin);
        };
        return fmt::format("; to world {}, to group {}, ray from {} in direction {}, point {} +- {}, normals {} and {}",
                           text(one.transforms.to_world), text(one.transforms.to_group), text_of(one.origin), text_of(one.direction), text_of(one.p),
                           text_of(one.error), text_of(one.geometric), text_of(one.shown));
    }

    static void look_at(const Case &one, const InstanceResult<float> &result, Findings &findings) {
        const ExtendedMap map(one.transforms.to_world), back(one.transforms.to_group);
        ++findings.hits;
        look_at_ray(one, result, map, back, findings);
        look_at_point(one, result, map, findings);
        look_at_normals(one, result, map, back, findings);
    }

    /// Both by the rounded inverse: its coefficients have 1 rounding, a sum of 4 products 3 more, which the kernel's comment rounds up to 2^-21 of
    /// the terms. And whatever begins in the group's box does so in the world's.
    static void look_at_ray(const Case &one, const InstanceResult<float> &result, const ExtendedMap &map, const ExtendedMap &back,
                            Findings &findings) {
        const Vector origin = wide(result.origin) - map.point_back(one.origin),
                     direction = wide(result.direction) - map.direction_back(one.direction);
        const Vector origin_terms = back.point_of_magnitudes(magnitude(one.origin)),
                     direction_terms = back.direction_of_magnitudes(magnitude(one.direction));
        for (int axis = 0; axis < 3; ++axis) {
            const extended of_origin = part(origin_terms, axis), of_direction = part(direction_terms, axis);
            findings.measure(Quantity::offset, double(absolute(part(origin, axis))), double(0x1p-21 * of_origin), ulp_of(of_origin),
                             double(of_origin), [&] { return "a ray's origin in the group is off" + text_of_case(one); });
            if (absolute(part(direction, axis)) > 0x1p-21 * of_direction)
                findings.blame([&] { return "a ray's direction in the group is off" + text_of_case(one); });
        }
        if (holds(one.box, wide(result.origin)) && !holds(bounds_in_world(one.transforms, one.box), one.origin))
            findings.blame([&] { return "a ray begins in the group's box and not in the world's" + text_of_case(one); });
    }

    /// The surface that the point stands for, anywhere within its error in the group, and where a ray that leaves the point finds itself in the
    /// group, lie within the error that it has in the world.
    static void look_at_point(const Case &one, const InstanceResult<float> &result, const ExtendedMap &map, Findings &findings) {
        const Vector p = wide(result.world.p), off = magnitude(p - map.point(one.p)), returned = magnitude(wide(result.back) - map.point_back(p));
        const Vector error = off + map.direction_of_magnitudes(Vector(one.error) + returned);
        for (int axis = 0; axis < 3; ++axis) {
            const double stated = result.world.error[axis], size = double(largest(p));
            findings.measure(Quantity::position, double(part(error, axis)), stated, ulp_of(size), size, [&] {
                return fmt::format("the point lies {:.3g} off, and says at most {:.3g}", double(part(error, axis)), stated) + text_of_case(one);
            });
        }
    }

    /// The shading normal lies on the geometric one's side.
    static void look_at_normals(const Case &one, const InstanceResult<float> &result, const ExtendedMap &map, const ExtendedMap &back,
                                Findings &findings) {
        const Vector geometric = map.normal(one.geometric), shown = map.normal(one.shown);
        const double turn = turn_of(geometric, back_normal_error(back, one.geometric)),
                     shown_turn = turn_of(shown, back_normal_error(back, one.shown));
        if (turn > 0.5 || shown_turn > 0.5) return findings.leave_out(Quantity::normal);
        findings.measure(Quantity::normal, double(length(wide(result.world.geometric) - unit(geometric))), turn, 2 * unit_roundoff, 1,
                         [&] { return "the geometric normal is off" + text_of_case(one); });
        const extended cosine = dot(unit(geometric), unit(shown));
        const bool known = absolute(cosine) > turn + shown_turn;
        findings.ambiguous += !known;
        const bool same_side = known ? cosine > 0 : dot(wide(result.world.normal), shown) > 0;
        findings.measure(Quantity::normal, double(length(wide(result.world.normal) - unit(shown) * (same_side ? 1 : -1))), shown_turn,
                         2 * unit_roundoff, 1, [&] { return "the shading normal is off" + text_of_case(one); });
    }

    /// Coefficients of the inverse have 1 rounding, sums of 3 products 3 more.
    static Vector back_normal_error(const ExtendedMap &back, vec3 n) { return back.normal_of_magnitudes(magnitude(n)) * (4 * unit_roundoff); }

    static void compare(const Case &one, const InstanceResult<float> &result, const InstanceResult<double> &exact, Findings &findings) {
        const ExtendedMap back(one.transforms.to_group);
        const Vector origin_terms = back.point_of_magnitudes(magnitude(one.origin)), origin = wide(result.origin) - wide(exact.origin);
        for (int axis = 0; axis < 3; ++axis) {
            const extended terms = part(origin_terms, axis);
            findings.rounding_of(Quantity::offset).add(double(absolute(part(origin, axis))), double(0x1p-21 * terms), ulp_of(terms), double(terms));
            const double size = double(largest(wide(exact.world.p)));
            findings.rounding_of(Quantity::position)
                .add(std::abs(result.world.p[axis] - exact.world.p[axis]), result.world.error[axis], ulp_of(size), size);
        }
        const double turn = turn_of(ExtendedMap(one.transforms.to_world).normal(one.geometric), back_normal_error(back, one.geometric));
        findings.rounding_of(Quantity::normal)
            .add(double(length(wide(result.world.geometric) - wide(exact.world.geometric))), turn, 2 * unit_roundoff, 1);
    }

    Device &device_;
    KernelInBoth kernel_;
};

}  // namespace

void add_instances(std::vector<SubjectEntry> &list) {
    list.push_back({"instances", "primitives/instance.cl, transform.cl",
                    "origins: 2^-21 of the terms; position: the surface's own error; normal: 4 roundings of the terms", 2,
                    [](Device &device) { return std::make_unique<Instances>(device); }});
}

}  // namespace brandung
