/// Crossings with every kind of primitive, and the surfaces there.
#include <fmt/format.h>

#include "runtime/selftest/crossing_kernels.h"
#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 17;
constexpr std::size_t compared = 8;  ///< one result of so many, with the one in double: it costs as much as the verdict and is none

vec3 vector_of(const float (&v)[3]) { return {v[0], v[1], v[2]}; }
template <class Number> Vector wide(const Number (&v)[3]) { return {v[0], v[1], v[2]}; }

class Crossings final : public Subject {
public:
    Crossings(Device &device, const PrimitiveOracle &oracle) : device_(device), oracle_(oracle), kernels_(device, oracle.kind()) {}

    Findings examine(uint round) override {
        const CrossingCases cases = make_cases(oracle_, inputs_per_round, seed_of(1, round, 0), any_placing, any_ray);
        const auto results = kernels_.in_float(cases);
        const auto doubles = kernels_.in_double(cases);
        const auto differences = kernels_.differences(cases);
        device_.finish();
        return examine_each(cases.rays.size(), [&](std::size_t i, Findings &findings) {
            const auto describe = [&](const std::string &what) { return what + describe_case(cases, i, round); };
            const Verdict verdict = look_at_crossing(cases, i, results[i], findings, describe);
            if (differences[i] != 0) findings.blame([&] { return describe(difference(differences[i])); });
            if (!results[i].hit || !verdict.fault.empty()) return;
            look_at_surface(cases, i, results[i], verdict, findings, describe);
            if (doubles && i % compared == 0 && (*doubles)[i].hit) compare(cases, i, results[i], (*doubles)[i], verdict, findings);
        });
    }

private:
    static std::string difference(std::uint8_t bits) {
        return fmt::format("other bits at {} lanes than at one", bits == differs_at_16 ? "16" : bits == differs_at_8 ? "8" : "8 and at 16");
    }

    template <class Describe>
    Verdict look_at_crossing(const CrossingCases &cases, std::size_t i, const CrossingResult<float> &result, Findings &findings,
                             Describe describe) const {
        const Ray &ray = cases.rays[i];
        const std::vector<Root> roots = oracle_.roots(cases.lane(i), ray);
        const Verdict verdict = judge(roots, {result.hit != 0, result.t}, ray.t_max);
        findings.hits += result.hit;
        findings.ambiguous += verdict.ambiguous;
        if (!verdict.fault.empty()) {
            findings.blame([&] { return describe(verdict.fault); });
        } else if (result.hit) {
            const double error = double(absolute(result.t - verdict.nearest)), t = double(verdict.nearest);
            findings.measure(Quantity::t, error, double(verdict.allowed), ulp_of(t), std::abs(t), [&] { return describe("t is off"); });
        }
        return verdict;
    }

    template <class Describe>
    void look_at_surface(const CrossingCases &cases, std::size_t i, const CrossingResult<float> &result, const Verdict &verdict, Findings &findings,
                         Describe describe) const {
        const vec3 n = vector_of(result.geometric);
        const double off = double(absolute(oracle_.distance(cases.lane(i), wide(result.p))));
        // Bounds and coordinates that are subnormal are rounded themselves.
        const double allowed = double(dot(Vector(glm::abs(n)), wide(result.error))) + 0x1p-147, size = double(largest(wide(result.p)));
        findings.measure(Quantity::position, off, allowed, ulp_of(size), size,
                         [&] { return describe(fmt::format("the point lies {:.3g} off the surface, and says at most {:.3g}", off, allowed)); });
        if (!(allowed <= 0x1p-18 * cases.extents[i] + 0x1p-147))
            findings.blame([&] { return describe(fmt::format("the point says that it may lie {:.3g} off, which is of no use", allowed)); });
        look_at_place(cases, i, result, verdict, findings, describe);
        look_at_coordinates(cases, i, result, findings, describe);
        const Normal normal = oracle_.normal_on(cases.lane(i), cases.rays[i], result.t);
        if (!(normal.error < 0.5)) {  // as at a tip seen from afar
            findings.leave_out(Quantity::normal);
            if (!cases.normals.empty()) findings.leave_out(Quantity::shading);
            return;
        }
        look_at_shading_normal(cases, i, result, normal, findings, describe);
        const double turned = double(length(Vector(n) - normal.n));
        findings.measure(Quantity::normal, turned, double(normal.error), 2 * unit_roundoff, 1,
                         [&] { return describe(fmt::format("the normal is off by {:.3g}, more than {:.3g}", turned, double(normal.error))); });
    }

    /// The point lies where the ray meets the surface, but for t's bound and the rounding of what it is made of: no more than 64 u of coordinates.
    template <class Describe>
    static void look_at_place(const CrossingCases &cases, std::size_t i, const CrossingResult<float> &result, const Verdict &verdict,
                              Findings &findings, Describe describe) {
        const Vector o = cases.rays[i].origin, d = cases.rays[i].direction, there = o + d * verdict.nearest;
        const extended off = length(wide(result.p) - there);
        const extended allowed = verdict.allowed * length(d) + 64 * unit_roundoff * (largest(o) + cases.extents[i]) + 0x1p-147;
        if (off <= allowed) return;
        findings.blame([&] {
            return describe(
                fmt::format("the point lies {:.3g} from where the ray meets the surface, more than {:.3g}", double(off), double(allowed)));
        });
    }

    /// From the first coordinate of a kind without vertices, which goes around, to its true one.
    extended around(extended difference) const {
        if (oracle_.kind().has_vertices || absolute(difference) <= 0.5) return difference;
        return difference < 0 ? difference + 1 : difference - 1;
    }

    template <class Describe>
    void look_at_coordinates(const CrossingCases &cases, std::size_t i, const CrossingResult<float> &result, Findings &findings,
                             Describe describe) const {
        const Place place = oracle_.place_on(cases.lane(i), cases.rays[i], result.t);
        const extended off[] = {absolute(around(result.uv[0] - place.uv[0])), absolute(result.uv[1] - place.uv[1])};
        for (uint k = 0; k < 2; ++k) {
            if (!(place.error[k] < 0.5)) {
                findings.leave_out(Quantity::uv);
                continue;
            }
            findings.measure(Quantity::uv, double(off[k]), double(place.error[k]), 2 * unit_roundoff, 1, [&] {
                return describe(fmt::format("{} is {:.9g}, and not {:.9g}, by more than {:.3g}", k == 0 ? "u" : "v", result.uv[k],
                                            double(place.uv[k]), double(place.error[k])));
            });
        }
    }

    /// On the geometric normal's side, where that can be told.
    template <class Describe>
    void look_at_shading_normal(const CrossingCases &cases, std::size_t i, const CrossingResult<float> &result, const Normal &geometric,
                                Findings &findings, Describe describe) const {
        const Vector n = wide(result.normal);
        if (cases.normals.empty()) {
            if (vector_of(result.normal) != vector_of(result.geometric)) findings.blame([&] { return describe("the shading normal is another"); });
            return;
        }
        const Normal exact = oracle_.shading_normal_on(cases.lane(i), cases.normals[i], cases.rays[i], result.t);
        if (!(exact.error < 0.5)) return findings.leave_out(Quantity::shading);
        const extended cosine = dot(exact.n, geometric.n), side = absolute(cosine) > exact.error + geometric.error ? cosine : dot(exact.n, n);
        const double turned = double(length(n - exact.n * (side < 0 ? -1 : 1)));
        findings.measure(Quantity::shading, turned, double(exact.error), 2 * unit_roundoff, 1,
                         [&] { return describe(fmt::format("the shading normal is off by {:.3g}, more than {:.3g}", turned, double(exact.error))); });
    }

    /// Of the same root, which doubles find to a thousandth of the floats' bound. Positions: how far they are from the surface; normals: from that at
    /// their own t.
    void compare(const CrossingCases &cases, std::size_t i, const CrossingResult<float> &result, const CrossingResult<double> &exact,
                 const Verdict &verdict, Findings &findings) const {
        if (absolute(exact.t - verdict.nearest) > 0x1p-10 * verdict.allowed) return;
        findings.rounding_of(Quantity::t).add(std::abs(result.t - exact.t), 2 * double(verdict.allowed), ulp_of(exact.t), exact.t);
        const Lane lane = cases.lane(i);
        const Vector p = wide(result.p), exact_p = wide(exact.p), turned = wide(result.geometric) - wide(exact.geometric);
        const double off = double(absolute(oracle_.distance(lane, p) - oracle_.distance(lane, exact_p))), size = double(largest(exact_p));
        const double allowed = double(dot(Vector(glm::abs(vector_of(result.geometric))), wide(result.error)));
        findings.rounding_of(Quantity::position).add(off, 2 * allowed, ulp_of(size), size);
        const Normal normal = oracle_.normal_on(lane, cases.rays[i], result.t), at_exact = oracle_.normal_on(lane, cases.rays[i], exact.t);
        if (!(normal.error < 0.5)) return;
        const double apart = double(length(turned - (normal.n - at_exact.n)));
        findings.rounding_of(Quantity::normal).add(apart, 2 * double(normal.error), 2 * unit_roundoff, 1);
        compare_coordinates(cases, i, result, exact, findings);
    }

    void compare_coordinates(const CrossingCases &cases, std::size_t i, const CrossingResult<float> &result, const CrossingResult<double> &exact,
                             Findings &findings) const {
        const Place here = oracle_.place_on(cases.lane(i), cases.rays[i], result.t), there = oracle_.place_on(cases.lane(i), cases.rays[i], exact.t);
        for (uint k = 0; k < 2; ++k) {
            const extended one = result.uv[k] - here.uv[k], other = exact.uv[k] - there.uv[k];
            const extended off = k == 0 ? around(one) - around(other) : one - other;
            if (here.error[k] < 0.5) findings.rounding_of(Quantity::uv).add(double(absolute(off)), 2 * double(here.error[k]), 2 * unit_roundoff, 1);
        }
        if (cases.normals.empty() || dot(wide(result.normal), wide(exact.normal)) < 0) return;
        const Normal shading = oracle_.shading_normal_on(cases.lane(i), cases.normals[i], cases.rays[i], result.t);
        if (!(shading.error < 0.5)) return;
        findings.rounding_of(Quantity::shading)
            .add(double(length(wide(result.normal) - wide(exact.normal))), 2 * double(shading.error), 2 * unit_roundoff, 1);
    }

    Device &device_;
    const PrimitiveOracle &oracle_;
    CrossingKernels kernels_;
};

}  // namespace

void add_crossings(std::vector<SubjectEntry> &list) {
    for (const PrimitiveOracle *oracle : primitive_oracles()) {
        const std::string name = oracle->kind().name;
        list.push_back({name, "primitives/" + name + "_hit.cl, " + name + ".cl",
                        "t: 8 ulp or the oracle's conditioning; position: the surface's own error; normals and uv: the oracle's conditioning", 3,
                        [oracle](Device &device) { return std::make_unique<Crossings>(device, *oracle); }});
    }
}

}  // namespace brandung
