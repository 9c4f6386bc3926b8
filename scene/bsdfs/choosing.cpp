#include "scene/bsdfs/choosing.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/bsdfs/bsdf.h"
#include "scene/kinds.h"
#include "scene/parameters.h"
#include "scene/scene.h"
#include "scene/textures/textured.h"

namespace brandung {
namespace {

const ChoosingKind &kind_of(const Material &material) { return choosing_kinds()[material.kind - bsdf_kinds().size()]; }

/// The materials on the way from one to its members, and theirs.
using Way = std::vector<uint>;

std::string named(const Scene &scene, const Way &way) {
    std::string names;
    for (const uint material : way) names += (names.empty() ? "\"" : " -> \"") + scene.materials[material].name + "\"";
    return names;
}

/// Why a material that chooses cannot be met at the end of this way; "" if it can.
std::string fault_of_way(const Scene &scene, Way way) {
    const uint end = way.back();
    if (std::find(way.begin(), way.end() - 1, end) != way.end() - 1) return "leads back to itself: " + named(scene, way);
    const Material &material = scene.materials[end].record;
    if (chooses(material) && way.size() > max_choices)
        return fmt::format("leads over more than {} materials that choose among others: {}", max_choices, named(scene, way));
    for (const uint member : members_of(material)) {
        way.push_back(member);
        if (std::string fault = fault_of_way(scene, way); !fault.empty()) return fault;
        way.pop_back();
    }
    return "";
}

/// Why it cannot be a member: what counts media and lights knows only the material that a thing has for all of its hits.
std::string fault_of_member(const NamedMaterial &member) {
    if ((member.record.flags & MATERIAL_TRANSMITS) != 0)
        return "material \"" + member.name + "\" has an inside, which a material that is one of several cannot; thin_dielectric has none";
    if (member.record.emission != Spectrum(0)) return "material \"" + member.name + "\" shines, which a material that is one of several cannot";
    return "";
}

}  // namespace

const std::vector<ChoosingKind> &choosing_kinds() {
    static const std::vector<ChoosingKind> kinds = {
        {"mix", {"first", "second"}, "amount", 0.5f},
        {"two_sided", {"front", "back"}, nullptr, 0},
        {"mask", {nullptr, "material"}, "opacity", 1},
    };
    return kinds;
}

Material make_choosing(const ChoosingKind &kind, Choice choice) {
    choice.by_side = kind.amount ? 0 : 1;
    Material material{};
    material.kind = static_cast<uint>(bsdf_kinds().size()) + kind_number(choosing_kinds(), kind.name);
    material.flags = MATERIAL_CHOOSES;
    material.eta = 1;
    write_words(choice, material.words);
    return material;
}

Material read_choosing(const Parameters &parameters, const ChoosingKind &kind, Scene &scene) {
    for (const char *key : kind.members)
        if (key) parameters.text(key);
    TexturedSpectrum amount{Spectrum(0), 0};
    if (kind.amount) amount = read_textured_fraction(parameters, kind.amount, Spectrum(kind.usual_amount), scene);
    Material material = make_choosing(kind, {{NO_MATERIAL, NO_MATERIAL}, 0, amount.value});
    material.diffuse_texture = amount.texture;
    return material;
}

void name_members(const Parameters &parameters, const std::vector<std::string> &names, Material &material) {
    const ChoosingKind &kind = kind_of(material);
    Choice choice = view_of<Choice>(material.words);
    for (std::size_t m = 0; m < 2; ++m)
        if (kind.members[m]) choice.members[m] = parameters.choice(kind.members[m], names);
    write_words(choice, material.words);
}

void expect_members(const Parameters &parameters, const Scene &scene, uint material) {
    if (!chooses(scene.materials[material].record)) return;
    if (const std::string fault = fault_of_way(scene, {material}); !fault.empty()) parameters.fail("", fault);
    const ChoosingKind &kind = kind_of(scene.materials[material].record);
    const Choice choice = view_of<Choice>(scene.materials[material].record.words);
    for (std::size_t m = 0; m < 2; ++m) {
        if (!kind.members[m]) continue;
        if (const std::string fault = fault_of_member(scene.materials[choice.members[m]]); !fault.empty()) parameters.fail(kind.members[m], fault);
    }
}

std::vector<uint> members_of(const Material &material) {
    if (!chooses(material)) return {};
    const Choice choice = view_of<Choice>(material.words);
    std::vector<uint> members(choice.members, choice.members + 2);
    std::erase(members, NO_MATERIAL);
    return members;
}

bool lets_light_pass(const Material &material) { return chooses(material) && members_of(material).size() < 2; }

void fill_in_passing(Material &material, uint number) {
    if (!chooses(material)) return;
    Choice choice = view_of<Choice>(material.words);
    std::replace(choice.members, choice.members + 2, NO_MATERIAL, number);
    write_words(choice, material.words);
}

const char *type_of(const Material &material) { return chooses(material) ? kind_of(material).name : bsdf_kinds()[material.kind].name; }

}  // namespace brandung
