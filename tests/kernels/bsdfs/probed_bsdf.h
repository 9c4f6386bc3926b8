/// A material whose functions on the device can be called from tests.
#pragma once
#include <string>
#include <vector>

#include "kernels/bsdfs/bsdf.h"
#include "kernels/core/scene.h"
#include "tests/kernels/bsdfs/materials.h"

namespace brandung {

/// The material as kernels read it: records of the size of its own follow, which hold the table of losses, or one of zeros if it has none.
std::vector<Material> with_loss_table(const Material &material);

class ProbedBsdf {
public:
    explicit ProbedBsdf(const TestedMaterial &tested);

    /// Of the directions in pairs; one wo may stand for all.
    std::vector<BsdfValue> eval(const std::vector<vec3> &wo, const std::vector<vec3> &wi) const;
    /// `numbers`: u and the choice.
    std::vector<BsdfSample> sample(const std::vector<vec3> &wo, const std::vector<vec3> &numbers) const;

private:
    std::vector<Material> material_;
    std::string kind_;
    float eta_, diffuse_tint_, specular_tint_;
};

}  // namespace brandung
