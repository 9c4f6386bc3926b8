#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "kernels/bsdfs/whitted.h"
#include "scene/error.h"
#include "scene/filters/filter.h"
#include "scene/formats/format.h"
#include "scene/lights/light.h"
#include "scene/tone.h"
#include "tests/scene/formats/native_text.h"

namespace brandung {
namespace {

/// One key per line, so that an error's line says which.
const char *const small_scene = R"({
"film": {"width": 64, "height": 48, "spp": 4, "seed": 7, "pixel": "random", "exposure": -1},
"integrator": {"type": "whitted", "max_depth": 9, "threshold": 0.01},
"accelerator": "none",
"background": [0.1, 0.2, 0.3],
"ambient": 0.25,
"camera": {"from": [0, 0, 5], "at": [0, 0, 0], "up": [0, 2, 0], "fov": 90, "inside": ["water"]},
"materials": [
{"name": "water", "type": "whitted", "diffuse": 0, "transmission": 1, "fresnel": true, "eta": 1.33, "priority": 3},
{"name": "grey", "type": "whitted"}],
"lights": [
{"type": "point", "position": [1, 2, 3], "intensity": 10},
{"type": "directional", "direction": [0, -2, 0], "irradiance": [1, 2, 3]}],
"objects": [
{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1},
{"type": "sphere", "material": "water", "center": [0, 0, 5], "radius": 1}]
})";

/// The small scene with `from` replaced by `to`.
std::string changed(const std::string &from, const std::string &to) {
    std::string text = small_scene;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

template <class View, class Record> View view_of(const Record &record) {
    View view;
    std::memcpy(&view, record.words, sizeof view);
    return view;
}

TEST(Native, ReadsEverySection) {
    const Scene scene = read_text(small_scene);
    EXPECT_EQ(scene.film.width, 64u);
    EXPECT_EQ(scene.film.height, 48u);
    EXPECT_EQ(scene.film.spp, 4u);
    EXPECT_EQ(scene.film.seed, 7u);
    EXPECT_EQ(scene.film.pixel, PIXEL_RANDOM);
    EXPECT_EQ(scene.film.exposure, -1.0f);
    EXPECT_EQ(scene.integrator.type, "whitted");
    EXPECT_EQ(scene.integrator.max_depth, 9u);
    EXPECT_EQ(scene.integrator.threshold, 0.01f);
    EXPECT_EQ(scene.accelerator, "none");
    EXPECT_EQ(scene.accelerator_quality, BuildQuality::fast) << "the default";
    EXPECT_EQ(scene.background, Spectrum(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.ambient, Spectrum(0.25f));
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.shapes[0]->material, 1u);
    EXPECT_EQ(scene.shapes[1]->material, 0u);
}

TEST(Native, TakesExposuresThatLeaveRadianceFinite) {
    for (const char *exposure : {"100", "-100"}) EXPECT_EQ(error_of_text(small_scene, {std::string("film.exposure=") + exposure}), "") << exposure;
    for (const char *exposure : {"100.1", "-1e15"})
        EXPECT_NE(error_of_text(small_scene, {std::string("film.exposure=") + exposure})
                      .find("/film/exposure (set on the command line): must be from -100 to 100"),
                  std::string::npos)
            << exposure;
}

TEST(Native, ReadsCameras) {
    const Scene one = read_text(small_scene);
    ASSERT_EQ(one.cameras.size(), 1u);
    EXPECT_EQ(one.cameras[0].from, vec3(0, 0, 5));
    EXPECT_EQ(one.cameras[0].up, vec3(0, 2, 0));
    EXPECT_NEAR(one.cameras[0].fov, std::acos(-1.0) / 2, 1e-6);
    EXPECT_EQ(one.cameras[0].inside, std::vector<std::string>{"water"});

    const Scene two =
        read_text(R"({"cameras": [{"name": "left", "from": [-1, 0, 0], "at": [0, 0, 0]}, {"name": "right", "from": [1, 0, 0], "at": [0, 0, 0]}]})");
    ASSERT_EQ(two.cameras.size(), 2u);
    EXPECT_EQ(two.cameras[1].name, "right");
}

TEST(Native, MakesMaterialRecords) {
    const Scene scene = read_text(small_scene);
    ASSERT_EQ(scene.materials.size(), 2u);
    const Material &water = scene.materials[0].record, &grey = scene.materials[1].record;
    EXPECT_EQ(water.flags, MATERIAL_TRANSMITS | MATERIAL_PASSES | MATERIAL_IDEAL);
    EXPECT_EQ(water.eta, 1.33f);
    EXPECT_EQ(water.priority, 3u);
    EXPECT_EQ(view_of<Whitted>(water).fresnel, 1u);
    EXPECT_EQ(view_of<Whitted>(water).transmission, Spectrum(1));
    // Defaults.
    EXPECT_EQ(grey.flags, MATERIAL_LIT | MATERIAL_DIFFUSE);
    EXPECT_EQ(grey.emission, Spectrum(0));
    EXPECT_EQ(view_of<Whitted>(grey).diffuse, Spectrum(0.5f));
    EXPECT_EQ(view_of<Whitted>(grey).ambient, Spectrum(0.5f));
    EXPECT_EQ(view_of<Whitted>(grey).exponent, 50.0f);
}

TEST(Native, ReadsWhichSideShines) {
    const Scene scene = read_text(R"({"camera": {"from": [1, 0, 0], "at": [0, 0, 0]}, "materials": [
        {"name": "a", "type": "whitted", "emission": 1}, {"name": "b", "type": "diffuse", "emission": 1, "emission_side": "front"},
        {"name": "c", "type": "plastic", "emission_side": "back"}, {"name": "d", "type": "whitted", "emission_side": "both"}]})");
    const uint sides = MATERIAL_DARK_FRONT | MATERIAL_DARK_BACK, expected[] = {0, MATERIAL_DARK_BACK, MATERIAL_DARK_FRONT, 0};
    for (std::size_t m = 0; m < 4; ++m) EXPECT_EQ(scene.materials[m].record.flags & sides, expected[m]) << m;
}

TEST(Native, MakesLightRecords) {
    const Scene scene = read_text(small_scene);
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_STREQ(light_kinds()[scene.lights[0].kind].name, "point");
    EXPECT_EQ(view_of<PointLight>(scene.lights[0]).position, vec3(1, 2, 3));
    EXPECT_EQ(view_of<PointLight>(scene.lights[0]).attenuation, vec3(0, 0, 1));
    EXPECT_STREQ(light_kinds()[scene.lights[1].kind].name, "directional");
    // The file says where the light goes, the record where it comes from.
    EXPECT_EQ(view_of<DirectionalLight>(scene.lights[1]).direction, vec3(0, 1, 0));
    EXPECT_EQ(view_of<DirectionalLight>(scene.lights[1]).irradiance, Spectrum(1, 2, 3));
}

SpotLight spot_of(const std::string &keys) {
    return view_of<SpotLight>(
        read_text(changed("{\"type\": \"point\", \"position\": [1, 2, 3]", "{\"type\": \"spot\", \"position\": [1, 2, 3], " + keys)).lights[0]);
}

/// 1 - cos 30° and 1 - cos 24° by default; 1 - cos 90° = 1 and, all of it being penumbra, 1 - cos 0 = 0.
TEST(Native, MakesSpotLightRecords) {
    const SpotLight plain = spot_of(R"("at": [1, 0, 3])");
    EXPECT_EQ(plain.direction, vec3(0, -1, 0));
    EXPECT_EQ(plain.intensity, Spectrum(10));
    EXPECT_EQ(plain.attenuation, vec3(0, 0, 1));
    EXPECT_FLOAT_EQ(plain.edge, 0.13397460f);
    EXPECT_FLOAT_EQ(plain.steepness, 1 / (0.13397460f - 0.086454542f));
    const SpotLight wide = spot_of(R"("direction": [0, 0, -5], "angle": 180, "penumbra": 1, "attenuation": [1, 2, 3])");
    EXPECT_EQ(wide.direction, vec3(0, 0, -1));
    EXPECT_EQ(wide.attenuation, vec3(1, 2, 3));
    EXPECT_FLOAT_EQ(wide.edge, 1);
    EXPECT_FLOAT_EQ(wide.steepness, 1);
}

TEST(Native, SetsValuesBeforeTheyAreInterpreted) {
    const Scene scene = read_text(small_scene, {"film.spp=64", "integrator.threshold=0", "lights.0.intensity=[1,2,3]", "camera.fov=30"});
    EXPECT_EQ(scene.film.spp, 64u);
    EXPECT_EQ(scene.integrator.threshold, 0.0f);
    EXPECT_EQ(view_of<PointLight>(scene.lights[0]).intensity, Spectrum(1, 2, 3));
    EXPECT_EQ(error_of_text(small_scene, {"film.spp=0"}), ": /film/spp (set on the command line): must be a whole number from 1 to 16777216, got 0");
    EXPECT_EQ(error_of_text(small_scene, {"film.sp=1"}), ": /film/sp (set on the command line): unknown key; is \"spp\" meant?");
}

TEST(Native, RefusesBadSettings) {
    EXPECT_EQ(error_of_text(changed("64", "0")), ":2: /film/width: must be a whole number from 1 to 65535, got 0");
    EXPECT_EQ(error_of_text(changed("48", "65536")), ":2: /film/height: must be a whole number from 1 to 65535, got 65536");
    EXPECT_EQ(error_of_text(changed("\"random\"", "\"middle\"")), ":2: /film/pixel: must be one of corner, center, random, got \"middle\"");
    EXPECT_EQ(error_of_text(changed("\"seed\"", "\"sead\"")), ":2: /film/sead: unknown key; is \"seed\" meant?");
    EXPECT_EQ(error_of_text(changed("\"random\"", "\"corner\"")), ":2: /film/pixel: 'corner' takes one sample per pixel, not 4");
    EXPECT_EQ(error_of_text(small_scene, {"film.pixel=corner"}),
              ": /film/pixel (set on the command line): 'corner' takes one sample per pixel, not 4");
    EXPECT_EQ(error_of_text(changed("9,", "1001,")), ":3: /integrator/max_depth: must be a whole number from 1 to 1000, got 1001");
    EXPECT_EQ(error_of_text(changed("\"none\"", "\"octopus\"")).substr(0, 38), ":4: /accelerator: must be one of auto,");
    EXPECT_EQ(error_of_text(changed("\"ambient\"", "\"ambiant\"")), ":6: /ambiant: unknown key; is \"ambient\" meant?");
    EXPECT_EQ(error_of_text(changed("0.25", "1e39")), ":6: /ambient: must be within the range of a float, got 1e+39");
    EXPECT_EQ(error_of_text(changed("0.25", "1e400")).substr(0, 22), ":6: number overflow pa");
}

TEST(Native, RefusesBadCameras) {
    EXPECT_EQ(error_of_text("{}"), ":1: needs either \"camera\" or \"cameras\"");
    EXPECT_EQ(error_of_text("{}", {"film.width=32"}), ":1: needs either \"camera\" or \"cameras\"") << "no fault of the setting";
    EXPECT_EQ(error_of_text(R"({"cameras": []})"), ":1: /cameras: must not be empty");
    EXPECT_EQ(error_of_text("{\"camera\": {},\n\"cameras\": []}"),
              ":2: /cameras: the scene has both \"camera\" and \"cameras\", but needs only one of them");
    EXPECT_EQ(error_of_text(changed("[0, 0, 0], \"up\"", "[0, 0, 5], \"up\"")), ":7: /camera/at: must differ from \"from\"");
    EXPECT_EQ(error_of_text(changed("[0, 2, 0]", "[0, 0, -2]")), ":7: /camera/up: must not be parallel to the view from \"from\" to \"at\"");
    EXPECT_EQ(error_of_text(changed("[0, 2, 0]", "[0, 0, 0]")), ":7: /camera/up: must not be zero");
    EXPECT_EQ(error_of_text(changed("90", "180")), ":7: /camera/fov: must be below 180 degrees, got 180");
    EXPECT_EQ(error_of_text(changed("90", "0")), ":7: /camera/fov: must be positive, got 0");
    EXPECT_EQ(error_of_text(changed("[\"water\"]", "[\"wine\"]")), ":7: /camera/inside: there is no material \"wine\"; transparent: water");
    EXPECT_EQ(error_of_text(changed("[\"water\"]", "[\"grey\"]")), ":7: /camera/inside: material \"grey\" is not transparent; transparent: water");
    EXPECT_EQ(
        error_of_text(
            "{\"cameras\": [{\"name\": \"a\", \"from\": [1, 0, 0], \"at\": [0, 0, 0]},\n{\"name\": \"a\", \"from\": [1, 0, 0], \"at\": [0, 0, 0]}]}"),
        ":2: /cameras/1/name: \"a\" is the name of an earlier one");
}

TEST(Native, RefusesBadMaterials) {
    EXPECT_EQ(error_of_text(changed("\"grey\", \"type\"", "\"water\", \"type\"")), ":10: /materials/1/name: \"water\" is the name of an earlier one");
    EXPECT_EQ(error_of_text(changed("\"whitted\", \"diffuse\"", "\"glass\", \"diffuse\"")),
              ":9: /materials/0/type: must be one of whitted, diffuse, conductor, plastic, phong, dielectric, thin_dielectric, null, mix, two_sided, "
              "mask, got \"glass\"");
    EXPECT_EQ(error_of_text(changed(", \"type\": \"whitted\"}", "}")), ":10: /materials/1: \"type\" is missing");
    EXPECT_EQ(error_of_text(changed("1.33", "0")), ":9: /materials/0/eta: must be positive, got 0");
    EXPECT_EQ(error_of_text(changed("\"transmission\": 1", "\"transmission\": 1.5")), ":9: /materials/0/transmission: must be at most 1, got 1.5");
    EXPECT_EQ(error_of_text(changed("\"priority\": 3", "\"priority\": 16777217")),
              ":9: /materials/0/priority: must be a whole number from 0 to 16777216, got 16777217");
}

TEST(Native, RefusesBadLights) {
    EXPECT_EQ(error_of_text(changed("\"intensity\": 10", "\"intensity\": -10")), ":12: /lights/0/intensity: must be not negative, got -10");
    EXPECT_EQ(error_of_text(changed("\"intensity\": 10", "\"intensity\": 1, \"attenuation\": [0, 0, 0]")),
              ":12: /lights/0/attenuation: must not be all zero, the intensity is divided by it");
    EXPECT_EQ(error_of_text(changed("\"intensity\": 10", "\"intensity\": 1, \"attenuation\": [0, -1, 1]")),
              ":12: /lights/0/attenuation: must not have negative parts");
    EXPECT_EQ(error_of_text(changed("[0, -2, 0]", "[0, 0, 0]")), ":13: /lights/1/direction: must not be zero");
}

TEST(Native, RefusesBadSpotLights) {
    const auto spot_error = [](const std::string &keys) {
        return error_of_text(changed("\"type\": \"point\", \"position\": [1, 2, 3]", "\"type\": \"spot\", \"position\": [1, 2, 3]" + keys));
    };
    EXPECT_EQ(spot_error(""), ":12: /lights/0: needs either \"direction\" or \"at\"");
    EXPECT_EQ(spot_error(R"(, "at": [0, 0, 0], "direction": [0, 0, 1])"),
              ":12: /lights/0/at: the light has both \"direction\" and \"at\", but needs only one of them");
    EXPECT_EQ(spot_error(R"(, "at": [1, 2, 3])"), ":12: /lights/0/at: must differ from \"position\"");
    EXPECT_EQ(spot_error(R"(, "direction": [0, 0, 0])"), ":12: /lights/0/direction: must not be zero");
    EXPECT_EQ(spot_error(R"(, "at": [0, 0, 0], "angle": 361)"), ":12: /lights/0/angle: must be at most 360 degrees, got 361");
    EXPECT_EQ(spot_error(R"(, "at": [0, 0, 0], "angle": 0)"), ":12: /lights/0/angle: must be positive, got 0");
    EXPECT_EQ(spot_error(R"(, "at": [0, 0, 0], "penumbra": 1.1)"), ":12: /lights/0/penumbra: must be at most 1, got 1.1");
}

TEST(Native, RefusesBadObjects) {
    EXPECT_EQ(error_of_text(changed("\"material\": \"grey\"", "\"material\": \"gray\"")),
              ":15: /objects/0/material: must be one of water, grey, got \"gray\"");
    EXPECT_EQ(error_of_text(changed("{\"type\": \"sphere\", \"material\": \"grey\"", "{\"type\": \"cube\", \"material\": \"grey\"")).substr(0, 37),
              ":15: /objects/0/type: must be one of ");
    EXPECT_EQ(error_of_text(changed("\"radius\": 1},", "\"radius\": -1},")), ":15: /objects/0/radius: must be not negative, got -1");
    EXPECT_EQ(error_of_text(changed("\"radius\": 1},", "\"radios\": 1},")), ":15: /objects/0: \"radius\" is missing; \"radios\" is unknown");
    EXPECT_EQ(error_of_text(changed("\"radius\": 1},", "\"radius\": 1, \"colour\": 1},")).substr(0, 51),
              ":15: /objects/0/colour: unknown key; known here: ce");
    EXPECT_EQ(error_of_text(changed("\"center\": [0, 0, 0]", "\"center\": [0, 1e16, 0]")).substr(0, 39), ":15: /objects/0/center/1: must be at mo");
    EXPECT_EQ(
        error_of_text(
            R"({"camera": {"from": [0, 0, 1], "at": [0, 0, 0]}, "objects": [{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1}]})"),
        ":1: /objects/0/material: the scene has no materials");
}

TEST(Native, RefusesWhatIsNoScene) {
    EXPECT_EQ(error_of_text(""), ": is empty");
    EXPECT_EQ(error_of_text("[1, 2]", {"film.width=32"}), ":1: must be an object, got an array of 2");
    for (const char *text : {"null", "3", "\"scene\"", "[]", " ", "{", "}", "\xff\xfe", "\xef\xbb\xbf"}) EXPECT_NE(error_of_text(text), "") << text;
    for (const char *key : {"film", "integrator", "accelerator", "accelerator_quality", "background", "ambient", "camera", "cameras", "materials",
                            "lights", "objects"}) {
        const std::string error = error_of_text(std::string("{\n\"") + key + "\": false}");
        EXPECT_EQ(error.substr(0, 5 + std::strlen(key)), std::string(":2: /") + key) << error;
    }
}

/// The warnings of a scene with these members beside its camera.
std::map<std::string, uint> warnings_of(const std::string &members) {
    return read_text(R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, )" + members + "}").warnings;
}

TEST(Native, WarnsOfScenesThatShowNothing) {
    const std::string objects = R"("objects": [{"type": "sphere", "material": "a", "center": [0, 0, 0], "radius": 1}], )";
    const std::string matte = objects + R"("materials": [{"name": "a", "type": "whitted"}])";
    const std::map<std::string, uint> none = {{"the scene has no objects", 1}},
                                      dark = {{"the scene has neither lights nor ambient light nor emission: its objects are black", 1}}, fine;
    EXPECT_EQ(warnings_of(R"("objects": [])"), none);
    EXPECT_EQ(warnings_of(matte), dark);
    EXPECT_EQ(warnings_of(matte + R"(, "background": 1)"), dark);
    EXPECT_EQ(warnings_of(matte + R"(, "ambient": 0.1)"), fine);
    EXPECT_EQ(warnings_of(matte + R"(, "lights": [{"type": "point", "position": [1, 2, 3], "intensity": 10}])"), fine);
    EXPECT_EQ(warnings_of(objects + R"("materials": [{"name": "a", "type": "whitted", "emission": 1}])"), fine);
    EXPECT_EQ(warnings_of(objects + R"("background": 1, "materials": [{"name": "a", "type": "whitted", "reflection": 1}])"), fine);
}

/// Where they are set: here in line 2, or by an option.
TEST(Native, WarnsOfSettingsThatItsIntegratorDoesNotUse) {
    const auto warnings = [](const std::string &integrator, const std::vector<std::string> &options = {}) {
        const Scene scene = read_text(R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "background": 1,
"integrator": {)" + integrator + R"(}, "materials": [{"name": "a", "type": "whitted", "diffuse": 0.5}],
"objects": [{"type": "sphere", "material": "a", "center": [0, 0, 0], "radius": 1}]})",
                                      options);
        std::string all;
        for (const auto &[text, place] : scene.warning_places) all += text + place.substr(place.find(".json") + 5) + "; ";
        return all;
    };
    EXPECT_EQ(warnings(R"("type": "path", "threshold": 0, "follow": "both", "shadows": "opaque", "light_samples": 0, "roulette_depth": 3)"), "");
    EXPECT_EQ(warnings(R"("type": "path", "light_samples": 2)"), "integrator.light_samples has no effect with path:2: /integrator/light_samples; ");
    EXPECT_EQ(warnings(R"("type": "path", "threshold": 0.1)"), "integrator.threshold has no effect with path:2: /integrator/threshold; ");
    EXPECT_EQ(warnings(R"("type": "distributed", "follow": "one", "bundles": {"light": 2})"),
              "integrator.follow has no effect with distributed:2: /integrator/follow; ");
    EXPECT_EQ(warnings(R"("type": "path", "bundles": {"light": 2})"), "integrator.bundles has no effect with path:2: /integrator/bundles; ");
    EXPECT_EQ(warnings(R"("type": "path")", {"integrator.shadows=filtered"}),
              "integrator.shadows has no effect with path: /integrator/shadows (set on the command line); ");
    EXPECT_EQ(warnings(R"("type": "path")", {"ambient=1"}), "ambient has no effect with path: /ambient (set on the command line); ");
    const std::vector<std::string> lit = {R"(lights=[{"type": "point", "position": [0, 0, 9], "intensity": 10}])"};
    EXPECT_EQ(warnings(R"("threshold": 0.1, "follow": "one", "shadows": "filtered")", lit), "");
    EXPECT_EQ(warnings(R"("roulette_depth": 3)", lit), "integrator.roulette_depth has no effect with whitted:2: /integrator/roulette_depth; ");
}

TEST(Native, WarnsOfPolygonsThatAreNotFlat) {
    const auto warnings = [](const std::string &last) {
        return warnings_of(R"("ambient": 1, "materials": [{"name": "a", "type": "whitted"}],
            "objects": [{"type": "polygon", "material": "a", "vertices": [[0, 0, 7], [1, 0, 7], [1, 1, 7], )" +
                           last + "]}]");
    };
    const std::map<std::string, uint> bent = {{"polygon whose corners do not lie in one plane: its triangles are bent against each other", 1}}, fine;
    EXPECT_EQ(warnings("[0, 1, 7]"), fine);
    EXPECT_EQ(warnings("[0, 1, 7.0001]"), fine) << "a file with few digits";
    EXPECT_EQ(warnings("[0, 1, 7.1]"), bent);
}

TEST(Native, EveryTruncationIsRefused) {
    const std::string text = small_scene;
    for (std::size_t size = 0; size < text.size(); ++size) EXPECT_NE(error_of_text(text.substr(0, size)), "") << size;
}

TEST(Native, NoChangedByteCrashes) {
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) {
        std::string text = small_scene;
        for (int changes = 0; changes <= i % 3; ++changes) text[random() % text.size()] = static_cast<char>(random());
        error_of_text(text);
    }
}

}  // namespace
}  // namespace brandung
