/// Renders that signals end.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/tools/program.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

/// A render of minutes, interrupted by `signal` after its first batch.
Finished interrupted_render(const TemporaryFolder &folder, const std::vector<std::string> &arguments, int signal) {
    std::vector<std::string> all = {"render", folder.write("scene.json", native_scene()), "--size", "512x512", "--spp", "100000", "--batch", "16384"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    RunOptions options;
    options.signal_when = [signal](const std::string &err) { return err.find("samples/s") != std::string::npos ? signal : 0; };
    return run_program(all, options);
}

}  // namespace

TEST(CliInterrupted, WritesThePictureSoFarAndExits130) {
    const TemporaryFolder folder;
    const Finished run = interrupted_render(folder, {"-o", folder.path("out.png"), "--stats", folder.path("stats.json")}, SIGINT);
    EXPECT_EQ(run.status, 130) << "signal " << run.signal << "\n" << run.err;
    EXPECT_FALSE(run.timed_out);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.png", "scene.json", "stats.json"}));
    const json stats = json::parse(read_file(folder.path("stats.json"))), rays = stats.at("rays");
    const std::string samples = stats.at("samples_done").dump() + " of 26214400000 samples";
    const std::string black = stats.at("spp") == 0 ? "; pixels not reached are black\n" : "\n";
    EXPECT_NE(run.err.find("interrupted: " + samples + black), std::string::npos) << run.err;
    EXPECT_EQ(stats.at("interrupted"), true);
    EXPECT_EQ(stats.at("samples_total"), 26214400000);
    EXPECT_EQ(stats.at("samples_done"), rays.at("camera"));
    const auto picture = OIIO::ImageInput::open(folder.path("out.png"));
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->spec().get_string_attribute("brandung:interrupted"), "true");
    EXPECT_EQ(picture->spec().get_string_attribute("brandung:samples"), samples);
    EXPECT_GE(rays.at("camera").get<std::uint64_t>(), 16384u);
    EXPECT_LT(rays.at("camera").get<std::uint64_t>(), 512ull * 512 * 100000);
}

/// With as many lights a batch takes seconds, which the first signal waits for.
TEST(CliInterrupted, TheSecondTimeEndsTheProgramAtOnce) {
    const TemporaryFolder folder;
    std::string lights;
    for (int i = 0; i < 6000; ++i) lights += "l 2 3 4\n";
    const std::string scene = folder.write("scene.nff", nff_scene(lights + "s 0 0 0 3\n"));
    RunOptions options;
    options.signal_when = [](const std::string &err) { return err.find("waves at most") != std::string::npos ? SIGINT : 0; };
    options.signals = 2;
    const Finished run = run_program({"render", scene, "-o", folder.path("out.png"), "--size", "256x128"}, options);
    EXPECT_EQ(run.signal, SIGINT) << "status " << run.status << "\n" << run.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.nff"});
}

TEST(CliInterrupted, ByTheTerminateSignalToo) {
    const TemporaryFolder folder;
    const Finished run = interrupted_render(folder, {"-o", folder.path("out.exr")}, SIGTERM);
    EXPECT_EQ(run.status, 130) << "signal " << run.signal << "\n" << run.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.exr", "scene.json"}));
}
