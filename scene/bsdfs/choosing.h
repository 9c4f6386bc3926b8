/// Materials that stand for others, of which one counts at every hit; kernels/stages/choose_materials.cl chooses.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "kernels/bsdfs/choice.h"
#include "kernels/core/scene.h"

namespace brandung {

class Parameters;
struct Scene;

/// So many of them may lead from one to another.
inline constexpr std::size_t max_choices = 4;

/// Such a material has MATERIAL_CHOOSES, a view Choice of its words, and of what other kinds have nothing. Material.kind is no place in bsdf_kinds(),
/// but as far behind their end as the kind's place in choosing_kinds().
struct ChoosingKind {
    const char *name;                     ///< in scene files
    std::array<const char *, 2> members;  ///< the keys that name them; null: lets all light pass
    const char *amount;                   ///< the key that says the chance of the second; null: the side chooses, the first is the outside's
    float usual_amount;
};
const std::vector<ChoosingKind> &choosing_kinds();

/// `choice.by_side` is the kind's.
Material make_choosing(const ChoosingKind &kind, Choice choice);
/// Without its members, whose names may be those of materials that are not read yet. May add a texture to the scene.
Material read_choosing(const Parameters &parameters, const ChoosingKind &kind, Scene &scene);
/// Once they are: `names` are those of the scene's materials.
void name_members(const Parameters &parameters, const std::vector<std::string> &names, Material &material);
/// Throws SceneError if the material chooses, once all have their members, and one of its members cannot be one.
void expect_members(const Parameters &parameters, const Scene &scene, uint material);

inline bool chooses(const Material &material) { return (material.flags & MATERIAL_CHOOSES) != 0; }
/// Of one that chooses; none of others.
std::vector<uint> members_of(const Material &material);
/// Whether it chooses, and may choose that all light passes.
bool lets_light_pass(const Material &material);
/// Gives a material that chooses the number of one that lets all light pass.
void fill_in_passing(Material &material, uint number);
/// What scene files call its kind, whether it chooses or not.
const char *type_of(const Material &material);

}  // namespace brandung
