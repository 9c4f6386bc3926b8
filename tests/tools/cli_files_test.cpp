/// What is read is never written over.
#include <gtest/gtest.h>

#include "scene/image.h"
#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using namespace brandung;

/// Runs the program, which must refuse its use in one line that contains `message`, and leave all files as they are.
void expect_refused(const TemporaryFolder &folder, const std::vector<std::string> &arguments, const std::string &message) {
    const auto texts = [&] {
        std::vector<std::string> texts = folder.names();
        for (std::string &name : texts) name += ":" + read_file(folder.path(name));
        return texts;
    };
    const std::vector<std::string> before = texts();
    const Finished run = run_program(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    EXPECT_EQ(texts() == before, true) << message;
}

void write_pictures(const TemporaryFolder &folder, const std::vector<std::string> &names) {
    for (const std::string &name : names) write_picture(folder.path(name), {1, 1, {Spectrum(0.5f)}, {}});
}

/// A scene that names a file of each kind.
std::string scene_of_many_files(const TemporaryFolder &folder) {
    write_pictures(folder, {"skin.png", "kd_001.png", "sky.png"});
    folder.write("mesh.mtl", "newmtl a\nmap_Kd kd_001.png\n");
    folder.write("mesh.obj", "mtllib mesh.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    return folder.write("scene.json", R"({"camera": {"from": [0, 0, 4], "at": [0, 0, 0]}, "ambient": 1, "background": {"image": "sky.png"},
        "materials": [{"name": "a", "type": "whitted", "diffuse": {"texture": "skin.png"}}],
        "objects": [{"type": "mesh", "file": "mesh.obj"}]})");
}

}  // namespace

TEST(CliFiles, NothingThatASceneIsReadFromIsWrittenOver) {
    const TemporaryFolder folder;
    const std::string scene = scene_of_many_files(folder), out = folder.path("out.png");
    for (const char *name : {"scene.json", "mesh.obj", "mesh.mtl", "skin.png", "sky.png"})
        expect_refused(folder, {"render", scene, "-o", out, "--stats", folder.path(name)},
                       "--stats: '" + folder.path(name) + "' would overwrite what is read (see --help)");
    std::filesystem::create_symlink("skin.png", folder.path("link.png"));
    expect_refused(folder, {"render", scene, "-o", folder.path("link.png")},
                   "/link.png' would overwrite what is read, '" + folder.path("skin.png") + "'");
    expect_refused(folder, {"render", scene, "-o", folder.path("kd.png"), "--turntable", "2"}, "kd_001.png' would overwrite what is read");
    expect_refused(folder, {"render", scene, "-o", out, "--stats", out}, "--stats: '" + out + "' would overwrite what --output writes");
}

TEST(CliFiles, PicturesThatAreComparedAreNotWrittenOver) {
    const TemporaryFolder folder;
    write_pictures(folder, {"a.png", "b.png"});
    for (const char *name : {"a.png", "b.png"})
        expect_refused(folder, {"compare", folder.path("a.png"), folder.path("b.png"), "--diff", folder.path(name)},
                       "--diff: '" + folder.path(name) + "' would overwrite what is read");
}

/// That the file asks for channels keeps nobody from a picture without any.
TEST(CliFiles, AovsOfTheSceneFileAreLeftOutOfPicturesWithoutChannels) {
    const TemporaryFolder folder;
    std::string text = native_scene();
    text.replace(text.find("\"spp\": 1"), 8, R"("spp": 1, "aovs": ["normal"])");
    const Finished run = run_program({"render", folder.write("scene.json", text), "-o", folder.path("out.png")});
    expect_success(run);
    EXPECT_NE(run.err.find("film.aovs: not recorded, since no output is an EXR"), std::string::npos) << run.err;
}
