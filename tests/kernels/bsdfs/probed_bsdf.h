/// A material whose functions on the device can be called from tests.
#pragma once
#include <string>
#include "kernels/bsdfs/bsdf.h"
#include "kernels/core/scene.h"
#include "tests/kernels/bsdfs/materials.h"

namespace brandung {

class ProbedBsdf {
public:
    explicit ProbedBsdf(const TestedMaterial &tested);

    /// Of the directions in pairs; one wo may stand for all.
    std::vector<BsdfValue> eval(const std::vector<vec3> &wo, const std::vector<vec3> &wi) const;
    /// `numbers`: u and the choice.
    std::vector<BsdfSample> sample(const std::vector<vec3> &wo, const std::vector<vec3> &numbers) const;

private:
    Material material_;
    std::string kind_;
    float eta_, diffuse_tint_, specular_tint_;
};

}  // namespace brandung
