#include "scene/meshes/mtl.h"

#include <gtest/gtest.h>

#include "tests/scene/meshes/mesh_folder.h"

namespace brandung {
namespace {

class Mtl : public testing::Test {
protected:
    /// The one material of a library with these statements.
    MtlMaterial read(const std::string &statements) {
        warnings.clear();
        const auto materials = read_mtl(folder.write("one.mtl", "newmtl one\n" + statements), warnings);
        return materials.at(0);
    }
    Material material(const std::string &statements) { return make_material(read(statements), warnings); }
    Whitted whitted(const std::string &statements) { return whitted_of(material(statements)); }
    std::string error(const std::string &statements) {
        try {
            read(statements);
        } catch (const SceneError &error) {
            const std::string what = error.what();
            return what.substr(what.rfind("one.mtl"));
        }
        return "";
    }

    MeshFolder folder;
    std::map<std::string, uint> warnings;
};

TEST_F(Mtl, ColoursAndHighlights) {
    const Whitted matte = whitted("Kd 0.25 0.5 0.75\nKa 20 20 20\n  Ks 0.5 # grey\nNs 32\nKe 1 2 3\nillum 1\n");
    EXPECT_EQ(matte.diffuse, Spectrum(0.25f, 0.5f, 0.75f));
    EXPECT_EQ(matte.ambient, matte.diffuse);
    EXPECT_EQ(matte.specular, Spectrum(0));
    EXPECT_EQ(material("Ke 1 2 3\n").emission, Spectrum(1, 2, 3));
    const Whitted shiny = whitted("Kd 0 0 0\nKs 0.5\nNs 32\n");
    EXPECT_EQ(shiny.specular, Spectrum(0.5f));
    EXPECT_EQ(shiny.exponent, 32);
    EXPECT_EQ(whitted("Ks 1\nNs 0\n").exponent, 1);
    EXPECT_EQ(whitted("").diffuse, Spectrum(0.6f));
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Mtl, Mirrors) {
    for (const char *illum : {"3", "5", "8"}) {
        const Material mirror = material(std::string("Kd 0.5 0.5 0.5\nKs 0.75 0.75 0.75\nillum ") + illum + "\n");
        EXPECT_EQ(whitted_of(mirror).reflection, Spectrum(0.75f));
        EXPECT_EQ(whitted_of(mirror).diffuse, Spectrum(0.125f));  // 0.5 (1 - 0.75)
        EXPECT_EQ(whitted_of(mirror).fresnel, 0u);
        EXPECT_EQ(mirror.flags & (MATERIAL_REFLECTS | MATERIAL_TRANSMITS), MATERIAL_REFLECTS);
    }
}

TEST_F(Mtl, Glass) {
    for (const char *illum : {"4", "7", "9"}) {
        const Material glass = material(std::string("Kd 0.5 0.5 0.5\nNi 1.33\nTf 1 0.5 0.75\nillum ") + illum + "\n");
        EXPECT_EQ(whitted_of(glass).transmission, Spectrum(1, 0.5f, 0.75f));
        EXPECT_EQ(whitted_of(glass).reflection, Spectrum(1));
        EXPECT_EQ(whitted_of(glass).fresnel, 1u);
        EXPECT_EQ(whitted_of(glass).diffuse, Spectrum(0, 0.25f, 0.125f));
        EXPECT_EQ(glass.eta, 1.33f);
    }
    EXPECT_EQ(material("illum 7\n").eta, 1.5f);
    EXPECT_EQ(whitted("illum 9\nd 0.25\n").transmission, Spectrum(0.75f));
    const Whitted without_fresnel = whitted("illum 6\nKs 0.25\n");
    EXPECT_EQ(without_fresnel.fresnel, 0u);
    EXPECT_EQ(without_fresnel.reflection, Spectrum(0.25f));
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(whitted("illum 7\nTf 0.25\n").transmission, Spectrum(0.75f));
    EXPECT_EQ(warnings.at("material of glass whose Tf is below 0.5: taken as opacity"), 1u);
}

TEST_F(Mtl, DissolvedSurfacesLetRaysThroughAsTheyAre) {
    for (const char *statement : {"d 0.25\n", "Tr 0.75\n", "d -halo 0.25\n"}) {
        const Material veil = material(std::string("Kd 1 1 1\nKs 0.5\nNi 1.5\n") + statement);
        EXPECT_EQ(whitted_of(veil).transmission, Spectrum(0.75f)) << statement;
        EXPECT_EQ(whitted_of(veil).diffuse, Spectrum(0.25f));
        EXPECT_EQ(whitted_of(veil).specular, Spectrum(0.125f));
        EXPECT_EQ(veil.eta, 1);
        EXPECT_TRUE(warnings.empty());
    }
    EXPECT_EQ(whitted("Kd 1\nTr 0.5\nd 0.75\n").transmission, Spectrum(0.25f));
    EXPECT_EQ(warnings.at("material whose d and Tr contradict each other: d counts"), 1u);
    whitted("Tr 1\n");
    EXPECT_EQ(warnings.at("material that is invisible (d 0 or Tr 1)"), 1u);
}

/// r = 0.5: (2 / 0.0625 - 2) / 4 = 7.5; sharp part (1 - r)^2 = 0.25.
TEST_F(Mtl, MetalsReflectWhatIsSharp) {
    const Whitted metal = whitted("Kd 0.5 1 0\nPm 1\nPr 0.5\n");
    EXPECT_EQ(metal.reflection, Spectrum(0.125f, 0.25f, 0));
    EXPECT_EQ(metal.diffuse, Spectrum(0.375f, 0.75f, 0));
    EXPECT_EQ(metal.specular, Spectrum(0.5f, 1, 0));
    EXPECT_FLOAT_EQ(metal.exponent, 7.5f);
    const Whitted plastic = whitted("Kd 0.5 0.5 0.5\nPr 0.5\n");
    EXPECT_EQ(plastic.reflection, Spectrum(0));
    EXPECT_EQ(plastic.specular, Spectrum(0.04f));
    EXPECT_EQ(whitted("Pm 1\nPr 0\n").exponent, 1e4f);
}

TEST_F(Mtl, TexturesHaveOptionsAndBlanksInTheirNames) {
    EXPECT_EQ(read("map_Kd texture 01.png\n").map_kd, "texture 01.png");
    EXPECT_EQ(read("map_Kd -o 0.1 -s 1 2 3 -clamp on my file.png  \r\n").map_kd, "my file.png");
    EXPECT_EQ(read("map_Ks 1.png -bm 1.5\n").map_ks, "1.png");
    EXPECT_EQ(read("map_kd -type sphere -colorspace sRGB a.jpg\n").map_kd, "a.jpg");
    EXPECT_EQ(read("map_Kd -s 1 1 infra.png\n").map_kd, "infra.png");
}

TEST_F(Mtl, TexturesShowAsTheyAreBesideBlack) {
    EXPECT_EQ(whitted("map_Kd a.png\n").diffuse, Spectrum(1));
    EXPECT_EQ(whitted("map_Kd a.png\nKd 0 0 0\nmap_Ks a.png\n").specular, Spectrum(1));
    EXPECT_EQ(whitted("map_Kd a.png\nKd 0.5 0.5 0\n").diffuse, Spectrum(0.5f, 0.5f, 0));
}

TEST_F(Mtl, WhatIsNotUsedIsCounted) {
    whitted("map_Bump b.png\nPc 1\nfoo 1\nKd spectral f.rfl\nKd 1 1 1 1\n");
    EXPECT_EQ(warnings, (std::map<std::string, uint>{{"material statement that Whitted's surface has nothing for (map_bump): not used", 1},
                                                     {"material statement that Whitted's surface has nothing for (pc): not used", 1},
                                                     {"unknown material statement: not used", 1},
                                                     {"material with a colour that is not three numbers: not used", 1},
                                                     {"material statement with more on its line than it takes: the rest is not used", 1}}));
    std::map<std::string, uint> early;
    EXPECT_TRUE(read_mtl(folder.write("early.mtl", "Kd 1 1 1\n"), early).empty());
    EXPECT_EQ(early.at("material statement before any newmtl: not used"), 1u);
}

TEST_F(Mtl, WhatMakesNoSenseIsAnErrorWithItsLine) {
    EXPECT_EQ(error("Kd 1 nan 0\n"), "one.mtl:2: colour of a material: expected a finite number in the range of a float, found \"nan\"");
    EXPECT_EQ(error("Kd 1 0 -1\n"), "one.mtl:2: colour of a material: must not be negative, got -1");
    EXPECT_EQ(error("\nNs\nNi 1\n"), "one.mtl:3: value of a material: expected a number on the line");
    EXPECT_EQ(error("Ns 1e16\n"), "one.mtl:2: value of a material: must be at most 1e+15 in magnitude, got 1e+16");
    EXPECT_EQ(error("illum 11\n"), "one.mtl:2: illum: must be from 0 to 10, got 11");
    EXPECT_EQ(error("illum high\n"), "one.mtl:2: illum: expected a whole number on the line");
}

}  // namespace
}  // namespace brandung
