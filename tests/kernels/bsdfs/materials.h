/// The materials that tests of BSDFs go through.
#pragma once
#include <vector>

namespace brandung {

struct TestedMaterial {
    const char *name;
    const char *text;  ///< as in a scene file
    /// Of cells that its lobes are counted in: alpha of facets, whose normals the cells are laid out for; 0: cells are alike in angle.
    float width;
    double white = 0;                           ///< if it absorbs nothing, by how much its albedo may differ from 1; 0: it absorbs
    float eta = 1;                              ///< BsdfPoint.eta
    bool reciprocal = true;                     ///< f is the same with the directions exchanged
    float diffuse_tint = 1, specular_tint = 1;  ///< by which pictures multiply its reflectances
};
const std::vector<TestedMaterial> &tested_materials();

}  // namespace brandung
