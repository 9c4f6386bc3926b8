#include "scene/meshes/mtl.h"

#include <gtest/gtest.h>

#include "tests/scene/meshes/mesh_folder.h"

namespace brandung {
namespace {

class Mtl : public testing::Test {
protected:
    /// The one material of a library with these statements.
    MtlMaterial read(const std::string &statements) {
        scene = {};
        const auto materials = read_mtl(folder.write("one.mtl", "newmtl one\n" + statements), scene);
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
    Scene scene;
    std::map<std::string, uint> &warnings = scene.warnings;
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
        EXPECT_EQ(whitted_of(glass).diffuse, Spectrum(0)) << "what is filtered out is lost";
        EXPECT_EQ(glass.eta, 1.33f);
    }
    EXPECT_EQ(material("illum 7\n").eta, 1.5f);
    EXPECT_EQ(material("illum 7\nNi 1e9\n").eta, 1.5f);
    EXPECT_EQ(warnings.at("material of glass whose Ni is not from 0.01 to 100: taken as 1.5"), 1u);
    EXPECT_EQ(whitted("illum 9\nd 0.25\n").transmission, Spectrum(0.75f));
    const Whitted without_fresnel = whitted("illum 6\nKs 0.25\n");
    EXPECT_EQ(without_fresnel.fresnel, 0u);
    EXPECT_EQ(without_fresnel.reflection, Spectrum(0.25f));
    EXPECT_TRUE(warnings.empty());
    for (const char *tf : {"0.4 0 0", "0.1 0.2 0.4", "0.5", "0.75 0.75 0.75"}) {
        const Spectrum filter = read(std::string("Tf ") + tf + "\n").tf.value();
        EXPECT_EQ(whitted(std::string("illum 7\nTf ") + tf + "\n").transmission, filter) << tf;
        EXPECT_TRUE(warnings.empty()) << tf;
    }
    EXPECT_EQ(whitted("illum 7\nTf 0.25\n").transmission, Spectrum(0.75f));
    EXPECT_EQ(whitted("illum 7\nTf 0.25\nKd 1\nd 0.5\n").diffuse, Spectrum(0.625f)) << "all but 0.5 0.75";
    EXPECT_EQ(warnings.at("material of glass whose Tf is grey below 0.5: taken as opacity"), 1u);
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
    whitted("d 0.2\nTr 0.8\n");
    whitted("d 0.333\nTr 0.667\n");
    whitted("illum 7\nd 0\n");
    EXPECT_TRUE(warnings.empty()) << "fractions of which floats are no more than near, and glass";
    whitted("Tr 1\n");
    EXPECT_EQ(warnings.at("material that is invisible (d 0 or Tr 1)"), 1u);
}

void expect_near(Spectrum value, Spectrum expected) {
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(value[c], expected[c]) << c;
}

/// r = 0.5: (2 / 0.0625 - 2) / 4 = 7.5; sharp part (1 - r)^2 = 0.25: diffuse 0.96 0.75 Kd, specular 0.75 0.04 + 0.25 Kd.
TEST_F(Mtl, MetalsReflectWhatIsSharp) {
    const Whitted metal = whitted("Kd 0.5 1 0\nPm 1\nPr 0.5\n");
    expect_near(metal.reflection, {0.125f, 0.25f, 0});
    expect_near(metal.diffuse, {0.36f, 0.72f, 0});
    expect_near(metal.specular, {0.155f, 0.28f, 0.03f});
    EXPECT_FLOAT_EQ(metal.exponent, 7.5f);
    const Whitted plastic = whitted("Kd 0.5 0.5 0.5\nPr 0.5\n");
    EXPECT_EQ(plastic.reflection, Spectrum(0));
    EXPECT_EQ(plastic.specular, Spectrum(0.04f));
    EXPECT_EQ(whitted("Pm 1\nPr 0\n").exponent, 1e4f);
    expect_near(whitted("Kd 0.5\nKs 1\nillum 3\nPm 1\nPr 1\n").diffuse, Spectrum(0.48f));  // illum makes it no mirror
}

TEST_F(Mtl, MetalsReflectNoMoreThanTheyGet) {
    for (const char *metallic : {"0", "0.25", "1"})
        for (const char *roughness : {"0", "0.25", "0.5", "1"})
            for (const char *illum : {"2", "3"}) {
                const Whitted metal = whitted(std::string("Kd 1\nKs 1\nPm ") + metallic + "\nPr " + roughness + "\nillum " + illum + "\n");
                EXPECT_LE(metal.diffuse.x + metal.specular.x, 1 + 1e-6f) << metallic << " " << roughness << " " << illum;
                EXPECT_LE(metal.diffuse.x + metal.reflection.x, 1 + 1e-6f) << metallic << " " << roughness << " " << illum;
            }
}

/// A picture colours the diffuse part alone.
TEST_F(Mtl, PicturesOfMetalsAreSeen) {
    const Whitted metal = whitted("Pm 1\nPr 0\nmap_Kd a.png\n");
    expect_near(metal.diffuse, Spectrum(0.96f));
    EXPECT_EQ(metal.reflection, Spectrum(0));
    expect_near(metal.specular, Spectrum(0.04f));
    EXPECT_EQ(warnings, (std::map<std::string, uint>{{"metal with a texture, which cannot colour mirror images: its reflections are diffuse", 1}}));
    whitted("Pm 1\nPr 1\nmap_Kd a.png\n");
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Mtl, TexturesHaveOptionsAndBlanksInTheirNames) {
    EXPECT_EQ(read("map_Kd texture 01.png\n").map_kd.file, "texture 01.png");
    EXPECT_EQ(read("map_Kd texture - 01.png\n").map_kd.file, "texture - 01.png");
    const MtlTexture placed = read("map_Kd -o 0.1 -s 3 2 1 -clamp on my file.png  \r\n").map_kd;
    EXPECT_EQ(placed.file, "my file.png");
    EXPECT_EQ(placed.offset, vec2(0.1f, 0));
    EXPECT_EQ(placed.scale, vec2(3, 2));
    EXPECT_TRUE(placed.clamps);
    const MtlTexture options_behind = read("map_Ks 1.png -bm 1.5 -o 0.25 0.5 -clamp off\n").map_ks;
    EXPECT_EQ(options_behind.file, "1.png");
    EXPECT_EQ(options_behind.offset, vec2(0.25f, 0.5f));
    EXPECT_EQ(options_behind.scale, vec2(1));
    EXPECT_FALSE(options_behind.clamps);
    EXPECT_EQ(read("map_Kd -s 1 1 infra.png\n").map_kd.file, "infra.png");
    EXPECT_EQ(read("map_Kd -s 1 nan.png\n").map_kd.file, "nan.png");
    EXPECT_EQ(read("map_Kd -s 1 1e16 2 a.png\n").map_kd.file, "1e16 2 a.png") << "too large to be a scale";
    EXPECT_EQ(read("map_Kd -s\n").map_kd.file, "");
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Mtl, OptionsOfTexturesThatAreNotUsedAreCounted) {
    EXPECT_EQ(read("map_kd -colorspace sRGB a.jpg\n").map_kd.encoding, Encoding::srgb);
    EXPECT_EQ(read("map_kd a.jpg -colorspace linear\n").map_kd.encoding, Encoding::linear);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(read("map_kd -type sphere -colorspace ACES -mm 0.5 2 a.jpg -blendu on\n").map_kd.file, "a.jpg");
    EXPECT_EQ(warnings, (std::map<std::string, uint>{{"option of a texture (-type): not used", 1},
                                                     {"option of a texture (-colorspace): not used", 1},
                                                     {"option of a texture (-mm): not used", 1}}));
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
    Scene early;
    EXPECT_TRUE(read_mtl(folder.write("early.mtl", "Kd 1 1 1\n"), early).empty());
    EXPECT_EQ(early.warnings.at("material statement before any newmtl: not used"), 1u);
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
