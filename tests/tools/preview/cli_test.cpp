/// render --preview, as a user has it.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/preview/tev_reader.h"
#include "tests/tools/program.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

std::vector<float> floats_of(const std::string &file) {
    const auto input = OIIO::ImageInput::open(file);
    if (!input) throw std::runtime_error(file + ": " + OIIO::geterror());
    std::vector<float> values(std::size_t{3} * input->spec().width * input->spec().height);
    input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, values.data());
    return values;
}

/// Of "preview: http://127.0.0.1:PORT/"; 0 as long as it has not been said.
int port_said(const std::string &err) {
    const std::string said = "preview: http://127.0.0.1:";
    const std::size_t place = err.find(said), end = place == err.npos ? err.npos : err.find("/\n", place);
    return end == err.npos ? 0 : std::stoi(err.substr(place + said.size()));
}

/// What the page's server answers; status -1 if nothing, which is a failure.
httplib::Response answer_to(int port, const char *path) {
    const httplib::Result result = httplib::Client("127.0.0.1", port).Get(path);
    EXPECT_TRUE(result) << path << ": " << httplib::to_string(result.error());
    return result ? *result : httplib::Response();
}

/// The state that the page's server tells; null if none.
json state_at(int port) {
    const httplib::Response answer = answer_to(port, "/state.json");
    return answer.status == 200 ? json::parse(answer.body) : json();
}

class PreviewOptions : public testing::Test {
protected:
    Finished run(const std::vector<std::string> &more, const RunOptions &options = {}, const char *size = "300x200") {
        std::vector<std::string> all = {"render", scene_, "--quiet", "--size", size, "-o", out_};
        all.insert(all.end(), more.begin(), more.end());
        return run_program(all, options);
    }

    TemporaryFolder folder_;
    const std::string scene_ = folder_.write("scene.json", native_scene()), out_ = folder_.path("out.exr");
};

TEST_F(PreviewOptions, TevHasWhatTheFileHasAndTheFileWhatItHasWithoutPreview) {
    ASSERT_EQ(run({}).status, 0);
    const std::vector<float> without = floats_of(out_);
    TevReader reader;
    const Finished finished = run({"--preview", reader.target(), "--batch", "4096", "--save-every", "0.001"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.err, "");
    const TevPicture picture = reader.finish();
    EXPECT_EQ(picture.fault, "");
    EXPECT_EQ(picture.name, out_);
    EXPECT_EQ(picture.values, without);
    EXPECT_EQ(floats_of(out_), without);
}

/// A render that takes hours, until the page has shown it and the file has been saved.
TEST_F(PreviewOptions, ThePageIsServedWhilePicturesAreSaved) {
    bool saved = false, shown = false;
    const auto look = [&](const std::string &err) {
        const int port = port_said(err);
        if (port == 0) return 0;
        const json state = state_at(port);
        if (state.is_null()) return SIGINT;
        shown |= state.at("phase") == "rendering" && state.at("samples_done") > 0 && answer_to(port, "/picture.png").status == 200;
        saved |= std::filesystem::exists(out_);
        return saved && shown ? SIGINT : 0;
    };
    const Finished finished =
        run({"--preview", "web:0", "--save-every", "0.1", "--spp", "1000000", "--batch", "4096"}, {.seconds = 100, .signal_when = look});
    EXPECT_EQ(finished.status, 130) << finished.err;
    EXPECT_TRUE(saved);
    EXPECT_TRUE(shown);
    EXPECT_FALSE(floats_of(out_).empty());
}

/// 24 MB, which no two sockets' buffers take: the end of the reader is met, however late it comes.
TEST_F(PreviewOptions, AViewerThatVanishesIsWarnedOfOnce) {
    TevReader reader(100);
    const Finished finished = run({"--preview", reader.target()}, {}, "2000x1000");
    EXPECT_EQ(finished.status, 0);
    EXPECT_TRUE(finished.err.starts_with("warning: --preview: tev at 127.0.0.1:")) << finished.err;
    EXPECT_EQ(lines_of(finished.err).size(), 1u) << finished.err;
    EXPECT_FALSE(floats_of(out_).empty());
}

TEST_F(PreviewOptions, ThePageGoesOnAsLongAsItWasTold) {
    json state;
    int picture = 0;
    const auto look = [&](const std::string &err) {
        const int port = port_said(err);
        if (port == 0) return 0;
        state = state_at(port);
        if (state.is_null()) return SIGINT;
        if (state.at("phase") != "done") return 0;
        picture = answer_to(port, "/picture.png").status;
        return SIGINT;
    };
    const Finished finished = run({"--preview", "web:0", "--preview-hold", "forever", "--batch", "32768"}, {.signal_when = look});
    EXPECT_EQ(finished.status, 0) << "the picture was complete";
    EXPECT_EQ(lines_of(finished.err).size(), 1u) << finished.err;
    EXPECT_EQ(picture, 200);
    EXPECT_EQ(state.at("scene"), scene_);
    EXPECT_EQ(state.at("samples_done"), 300 * 200);
    EXPECT_EQ(state.at("part"), 1);
    EXPECT_EQ(state.at("rays").at("camera"), 300 * 200);
    // The scene mirrors nothing: a batch has a step for the rays from the eye, and an end. 300 * 200 = 32768 + 27232.
    EXPECT_EQ(state.at("queues").at("steps"), json::parse("[[0, 32768, [32768]], [0, 0, [0]], [0, 27232, [27232]], [0, 0, [0]]]"));
    EXPECT_FALSE(floats_of(out_).empty()) << "it was written before";
}

TEST_F(PreviewOptions, WithoutAnOpenPageTheProgramEndsAtOnce) {
    const Finished finished = run({"--preview", "web:0"}, {.seconds = 60});
    EXPECT_EQ(finished.status, 0);
    EXPECT_NE(port_said(finished.err), 0);
}

TEST_F(PreviewOptions, WhatCannotBeShownIsAnErrorBeforeTheRender) {
    const int nobody = TevReader().port();
    const Finished no_tev = run({"--preview", "tev:127.0.0.1:" + std::to_string(nobody)});
    EXPECT_EQ(no_tev.status, 1);
    EXPECT_EQ(no_tev.err, "brandung: --preview: no tev at 127.0.0.1:" + std::to_string(nobody) + ": Connection refused; start it first\n");

    const TevReader taken;
    const Finished no_port = run({"--preview", "web:" + std::to_string(taken.port())});
    EXPECT_EQ(no_port.status, 1);
    EXPECT_EQ(no_port.err, "brandung: --preview: cannot listen at 127.0.0.1:" + std::to_string(taken.port()) + ": Address already in use\n");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
}

TEST_F(PreviewOptions, WrongUsageIsSaid) {
    for (const std::vector<std::string> &options : {std::vector<std::string>{"--preview", "tv"},
                                                    {"--preview-hold", "3"},
                                                    {"--preview", "web:0", "--preview-hold", "nan"},
                                                    {"--preview", "web:0", "--preview-hold", "inf"}}) {
        const Finished finished = run(options);
        EXPECT_EQ(finished.status, 2) << options.back();
        EXPECT_TRUE(finished.err.starts_with("brandung: --preview")) << finished.err;
    }
}

}  // namespace
