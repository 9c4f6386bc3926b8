#include "tests/kernels/bsdfs/probed_bsdf.h"

#include <cstddef>
#include <cstring>
#include <map>
#include <memory>

#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/losses.h"
#include "scene/kinds.h"
#include "scene/parameters.h"
#include "scene/scene.h"
#include "tests/support/probe.h"

namespace brandung {
namespace {

/// One of each kind and function: programs take their time to build.
Probe &probe_of(const std::string &kind, const std::string &call, const std::string &result) {
    static std::map<std::string, std::unique_ptr<Probe>> probes;
    std::unique_ptr<Probe> &probe = probes[kind + call];
    if (!probe)
        probe = std::make_unique<Probe>(
            "#include \"kernels/bsdfs/" + kind + R"(.cl"
            kernel void probe(const global Material *m, const global float *eta, const global float *diffuse_tint,
                              const global float *specular_tint, const global vec3 *wo, const global vec3 *x, global )" +
                result + R"( *results) {
                const uint i = get_global_id(0);
                BsdfPoint point;
                point.wo = load(wo + i), point.eta = *eta;
                point.diffuse_tint = make3(*diffuse_tint, *diffuse_tint, *diffuse_tint);
                point.specular_tint = make3(*specular_tint, *specular_tint, *specular_tint);
                const vec3 number = load(x + i);
                vec2 u;
                u.x = number.x, u.y = number.y;
                results[i] = )" +
                kind + call + "; }",
            Sources{{"generated/constants.h", "#define FACETS 3u\n"}, {"generated/losses.cl", "#include \"kernels/bsdfs/losses.cl\"\n"}});
    return *probe;
}

/// Tables take their time too: that of each text is computed once.
const std::vector<Material> &records_of(const std::string &text, const Material &material) {
    static std::map<std::string, std::vector<Material>> records;
    std::vector<Material> &result = records[text];
    if (result.empty()) result = with_loss_table(material);
    return result;
}

/// Without those that a probe gives for the other records of a material.
template <class Result> std::vector<Result> first(std::vector<Result> results, std::size_t count) {
    results.resize(count);
    return results;
}

std::vector<vec3> repeated(const std::vector<vec3> &wo, std::size_t count) { return wo.size() == count ? wo : std::vector<vec3>(count, wo.at(0)); }

}  // namespace

std::vector<Material> with_loss_table(const Material &material) {
    static_assert(sizeof(LossTable) % sizeof(Material) == 0);
    const std::vector<std::byte> records = with_losses({material}, {true});
    std::vector<Material> result(1 + sizeof(LossTable) / sizeof(Material));
    std::memcpy(result.data(), records.data(), records.size());
    return result;
}

ProbedBsdf::ProbedBsdf(const TestedMaterial &tested) : eta_(tested.eta), diffuse_tint_(tested.diffuse_tint), specular_tint_(tested.specular_tint) {
    const Document document = parse_document("material", tested.text);
    const Parameters parameters(document, "");
    Scene scene;
    kind_ = parameters.text("type");
    material_ = records_of(tested.text, bsdf_kinds()[kind_number(bsdf_kinds(), kind_)].read(parameters, scene));
    parameters.expect_all_known();
}

std::vector<BsdfValue> ProbedBsdf::eval(const std::vector<vec3> &wo, const std::vector<vec3> &wi) const {
    Probe &probe = probe_of(kind_, "_eval(m, point, number)", "BsdfValue");
    return first(probe.run<BsdfValue>(material_, eta_, diffuse_tint_, specular_tint_, repeated(wo, wi.size()), wi), wi.size());
}

std::vector<BsdfSample> ProbedBsdf::sample(const std::vector<vec3> &wo, const std::vector<vec3> &numbers) const {
    Probe &probe = probe_of(kind_, "_sample(m, point, u, number.z)", "BsdfSample");
    return first(probe.run<BsdfSample>(material_, eta_, diffuse_tint_, specular_tint_, repeated(wo, numbers.size()), numbers), numbers.size());
}

}  // namespace brandung
