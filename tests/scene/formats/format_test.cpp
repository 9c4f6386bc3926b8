#include "scene/formats/format.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/error.h"
#include "tests/scene/formats/temporary_file.h"

namespace brandung {
namespace {

const char *const nearly_empty = R"({"camera": {"from": [0, 0, 1], "at": [0, 0, 0]}})";

TEST(ReadScene, NamesFilesThatCannotBeRead) {
    const auto error = [](const std::string &file) {
        try {
            read_scene(file);
        } catch (const SceneError &what) {
            return std::string(what.what());
        }
        return std::string();
    };
    EXPECT_EQ(error("/no/such.json"), "/no/such.json: no such file");
    EXPECT_EQ(error("/"), "/: is a folder, not a file");
    const TemporaryFile unknown("{}", ".xyz");
    EXPECT_EQ(error(unknown.path), unknown.path + ": unknown scene format \".xyz\"; known by extension: .json .nff .obj .ply");
}

TEST(ReadScene, ExtensionsMayBeUpperCase) {
    const TemporaryFile file(nearly_empty, ".JSON");
    EXPECT_EQ(read_scene(file.path).cameras.size(), 1u);
}

TEST(Examples, AllRead) {
    std::size_t examples = 0;
    for (const auto &entry : std::filesystem::directory_iterator(BRANDUNG_SOURCE_DIR "/scene/examples")) {
        if (entry.path().extension() != ".json" && entry.path().extension() != ".nff") continue;  // what scenes are made of
        const Scene scene = read_scene(entry.path());
        EXPECT_TRUE(scene.warnings.empty()) << entry.path();
        EXPECT_FALSE(scene.shapes.empty()) << entry.path();
        const auto shines = [](const NamedMaterial &material) { return material.record.emission != Spectrum(0); };
        EXPECT_TRUE(!scene.lights.empty() || std::any_of(scene.materials.begin(), scene.materials.end(), shines)) << entry.path();
        ++examples;
    }
    EXPECT_GE(examples, 6u);
}

}  // namespace
}  // namespace brandung
