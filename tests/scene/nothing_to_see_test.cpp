/// Scenes that show nothing are warned of.
#include "scene/nothing_to_see.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scene/meshes/mesh_folder.h"

namespace brandung {
namespace {

const std::string dark = "the scene has neither lights nor ambient light nor emission: its objects are black",
                  blank = "material that reflects, lets through and emits nothing, as all that are seen: the objects are black",
                  shown = "material that shows nothing of the scene's light, as all that are seen: the objects are black";

/// "WHAT (COUNT, PLACE)" of the one warning, whose place begins with `file`; empty without one.
std::string warning_of(const Scene &scene, const std::string &file) {
    EXPECT_LE(scene.warnings.size(), 1u);
    if (scene.warnings.empty()) return "";
    const auto &[text, count] = *scene.warnings.begin();
    const std::string &place = scene.warning_places.at(text);
    EXPECT_TRUE(place.starts_with(file)) << place;
    return text + " (" + std::to_string(count) + place.substr(std::min(file.size(), place.size())) + ")";
}

class NothingToSee : public testing::Test {
protected:
    /// Two spheres with materials a and b, a third material that nothing has, and `more`.
    std::string native(const std::string &a, const std::string &b, const std::string &more) {
        const std::string file = folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "materials": [
{"name": "bright", "type": "whitted", "emission": 1},
{"name": "a", "type": "whitted", "diffuse": 0, )" + a + R"(},
{"name": "b", "type": "whitted", "diffuse": 0, )" + b + R"(}], )" +
                                                                more + R"(
"objects": [{"type": "sphere", "material": "a", "center": [0, 0, 0], "radius": 1}, {"type": "sphere", "material": "b", "center": [0, 3, 0], "radius": 1}]})");
        return warning_of(read_scene(file), file);
    }
    /// A triangle of material m and one of n, as a file of its own, with this library.
    std::string mesh(const std::string &library) {
        const std::string lib = folder.write("a.mtl", library);
        const std::string file = folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\nusemtl n\nf 1 3 2\n");
        return warning_of(read_scene(file), lib);
    }

    const std::string nothing = R"("specular": 0)", lights = R"("lights": [{"type": "point", "position": [1, 2, 3], "intensity": 10}],)";
    MeshFolder folder;
};

TEST_F(NothingToSee, MaterialsThatDoNothingWithLight) {
    EXPECT_EQ(native(nothing, nothing, lights), blank + " (2:3: /materials/1)");
    EXPECT_EQ(native(nothing, nothing, R"("ambient": 1, "background": 1,)"), blank + " (2:3: /materials/1)");
}

TEST_F(NothingToSee, ABackgroundLightsByPathsOnly) {
    const std::string matte = R"("specular": 0.1)";
    EXPECT_EQ(native(nothing, matte, R"("background": 1, "integrator": {"type": "path"},)"), "");
    EXPECT_EQ(native(nothing, matte, R"("background": 1,)"), dark + " (1)");
    EXPECT_EQ(native(nothing, matte, R"("integrator": {"type": "path"},)"), dark + " (1)");
}

/// Metals and glass by paths, of which each says by its own kind what it shows.
TEST_F(NothingToSee, MirrorsAndGlassOfAllKindsShowTheBackground) {
    const auto warning = [&](const std::string &material, const std::string &more) {
        const std::string file = folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "integrator": {"type": "path"},
"materials": [{"name": "a", )" + material + R"(}], "objects": [{"type": "sphere", "material": "a", "center": [0, 0, 0], "radius": 1}])" +
                                                                more + "}");
        return warning_of(read_scene(file), file);
    };
    const std::string gold = R"("type": "conductor", "metal": "gold")";
    for (const std::string &material : {gold, gold + R"(, "roughness": 0.3)", std::string(R"("type": "dielectric")"),
                                        std::string(R"("type": "thin_dielectric")"), std::string(R"("type": "plastic", "diffuse": 0)")}) {
        EXPECT_EQ(warning(material, R"(, "background": 0.5)"), "") << material;
        EXPECT_EQ(warning(material, ""), dark + " (1)") << material;
    }
    EXPECT_EQ(warning(gold + R"(, "specular": 0)", R"(, "lights": [{"type": "point", "position": [1, 2, 3], "intensity": 10}])"),
              blank + " (1:2: /materials/0)");
}

/// Which paths do without.
TEST_F(NothingToSee, AmbientLightAloneLightsNoPaths) {
    const Scene scene = read_scene(folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "integrator": {"type": "path"},
"ambient": 1, "materials": [{"name": "a", "type": "whitted"}],
"objects": [{"type": "sphere", "material": "a", "center": [0, 0, 0], "radius": 1}]})"));
    EXPECT_EQ(scene.warnings.count(dark), 1u);
    EXPECT_EQ(scene.warnings.count("ambient has no effect with path"), 1u);
}

TEST_F(NothingToSee, OneMaterialThatShowsSomethingSuffices) {
    for (const char *some : {R"("specular": 0.1)", R"("emission": [0, 0, 1])"}) EXPECT_EQ(native(nothing, some, lights), "") << some;
    EXPECT_EQ(native(nothing, R"("ambient": 0.1)", R"("ambient": 0.1,)"), "");
    for (const char *some : {R"("reflection": 0.1)", R"("transmission": 0.1)"}) EXPECT_EQ(native(nothing, some, R"("background": 0.1,)"), "") << some;
}

/// Mirrors see each other and a black background; ambient light meets highlights only, lights what reflects ambient light only.
TEST_F(NothingToSee, LightThatNoMaterialShows) {
    EXPECT_EQ(native(nothing, R"("reflection": 1)", lights), shown + " (2:3: /materials/1)");
    EXPECT_EQ(native(nothing, R"("specular": 1)", R"("ambient": 1,)"), shown + " (2:3: /materials/1)");
    EXPECT_EQ(native(nothing, R"("ambient": 1)", lights), shown + " (2:3: /materials/1)");
}

TEST_F(NothingToSee, NoLightAtAll) {
    EXPECT_EQ(native(nothing, R"("ambient": 1, "specular": 1)", ""), dark + " (1)");
    EXPECT_EQ(native(nothing, nothing, R"("background": 1,)"), dark + " (1)");
}

TEST_F(NothingToSee, BareMeshesInTheDefaultViewToo) {
    EXPECT_EQ(mesh("# black\nnewmtl m\nKd 0 0 0\n\nnewmtl n\nKd 0 0 0\nKs 0 0 0\nillum 2\n"), blank + " (2:2)");
    EXPECT_EQ(mesh("newmtl n\nKd 0 0 0.5\nnewmtl m\nKd 0 0 0\n"), "");
    EXPECT_EQ(mesh("newmtl n\nKd 0 0 0\nKe 0 0.1 0\nnewmtl m\nKd 0 0 0\n"), "");
}

/// Only what an instance shows counts, in the material that it gives.
TEST_F(NothingToSee, GroupsAsTheirInstancesShowThem) {
    const auto warning = [&](const std::string &instance) {
        const std::string file = folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "ambient": 1, "materials": [
{"name": "black", "type": "whitted", "diffuse": 0}, {"name": "grey", "type": "whitted"}],
"groups": [{"name": "black", "objects": [{"type": "sphere", "material": "black", "center": [0, 0, 0], "radius": 1}]},
           {"name": "grey", "objects": [{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1}]}],
"objects": [{"type": "instance", "group": )" + instance + "}]}");
        return warning_of(read_scene(file), file);
    };
    EXPECT_EQ(warning(R"("black")"), blank + " (1:2: /materials/0)");
    EXPECT_EQ(warning(R"("black", "material": "grey")"), "");
    EXPECT_EQ(warning(R"("grey")"), "");
    EXPECT_EQ(warning(R"("grey", "material": "black")"), blank + " (1:2: /materials/0)");
}

}  // namespace
}  // namespace brandung
