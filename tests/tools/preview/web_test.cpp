/// The web page's server, against an HTTP client.
#include "tools/preview/web.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "scene/error.h"
#include "tests/tools/preview/states.h"

namespace brandung {
namespace {

using nlohmann::json;

int port_of(const WebViewer &viewer) { return std::stoi(viewer.url().substr(viewer.url().rfind(':') + 1)); }

httplib::Client client_of(const WebViewer &viewer) { return httplib::Client("127.0.0.1", port_of(viewer)); }

/// Bytes of a PNG, 3 per pixel.
std::vector<std::uint8_t> decode(const std::string &png, int width, int height) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char *>(png.data()), png.size());
    const auto input = OIIO::ImageInput::open("picture.png", nullptr, &memory);
    if (!input || input->spec().width != width || input->spec().height != height || input->spec().nchannels != 3) return {};
    std::vector<std::uint8_t> bytes(std::size_t{3} * width * height);
    input->read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT8, bytes.data());
    return bytes;
}

std::shared_ptr<const Picture> grey(float value) { return std::make_shared<const Picture>(Picture{5, 4, std::vector<vec3>(20, vec3(value)), {}}); }

TEST(Web, ServesAPageThatNeedsNothingFromElsewhere) {
    const WebViewer viewer(0);
    const auto answer = client_of(viewer).Get("/");
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 200);
    EXPECT_EQ(answer->get_header_value("Content-Type"), "text/html; charset=utf-8");
    EXPECT_NE(answer->get_header_value("Content-Security-Policy").find("default-src 'none'"), std::string::npos);
    EXPECT_TRUE(answer->body.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(answer->body.ends_with("</html>\n"));
    for (const char *address : {"http://", "https://", "//cdn"}) EXPECT_EQ(answer->body.find(address), std::string::npos) << address;
}

TEST(Web, StateHasEveryPromisedName) {
    WebViewer viewer(0);
    EXPECT_EQ(json::parse(client_of(viewer).Get("/state.json")->body).at("phase"), "preparing") << "before anything is known";
    viewer.show(test_state(nullptr));
    const auto answer = client_of(viewer).Get("/state.json");
    EXPECT_EQ(answer->get_header_value("Content-Type"), "application/json");
    EXPECT_EQ(json::parse(answer->body), json::parse(R"({
        "scene": "scenes/a.json", "integrator": "whitted", "accelerator": "wide_bvh", "device": "a device",
        "width": 300, "height": 140, "spp": 4, "exposure": 0.0, "phase": "rendering", "doing": null,
        "part": 0.5, "samples_done": 50, "samples_total": 200, "seconds": 1.5,
        "samples_per_second": 40.0, "rays_per_second": 100.0, "seconds_left": 3.75,
        "noise": {"relmse": 0.25, "confidence_95": [0.125, 0.5]},
        "rays": {"camera": 50, "camera_hits": 40, "reflected": 30, "reflected_hits": 10, "refracted": 20, "refracted_hits": 5,
                 "shadow": 25, "shadow_hits": 1, "total": 125},
        "kernels": [{"name": "intersect", "launches": 3, "items": 100, "milliseconds": 7.5},
                    {"name": "shade", "launches": 3, "items": 90, "milliseconds": 2.5}],
        "queues": {"batch": 1000, "steps": [[0, 50, [50]], [1, 30, [0, 30]], [0, 0, [0, 0]]]}})"));
}

/// A file's name need not be UTF-8, JSON must be.
TEST(Web, StateIsJsonWhateverTheScenesName) {
    WebViewer viewer(0);
    PreviewState state;
    state.subject.scene = "a\xff\"b";
    viewer.show(std::make_shared<const PreviewState>(state));
    const auto answer = client_of(viewer).Get("/state.json");
    EXPECT_EQ(answer->status, 200);
    EXPECT_EQ(json::parse(answer->body).at("scene"), "a\xef\xbf\xbd\"b");
}

/// sRGB's 8 bits of 0.5 and of 0.125 are 188 and 99 (IEC 61966-2-1).
TEST(Web, PictureIsTheLatestThroughExposureAndTheSrgbCurve) {
    WebViewer viewer(0);
    viewer.show(test_state(grey(0.125f), PreviewPhase::done));
    httplib::Client client = client_of(viewer);
    const auto pixels = [&](const char *path) {
        const auto answer = client.Get(path);
        EXPECT_EQ(answer->get_header_value("Content-Type"), "image/png");
        return decode(answer->body, 5, 4);
    };
    EXPECT_EQ(pixels("/picture.png"), std::vector<std::uint8_t>(60, 99));
    EXPECT_EQ(pixels("/picture.png?exposure=2"), std::vector<std::uint8_t>(60, 188));
    EXPECT_EQ(pixels("/picture.png?exposure=30"), std::vector<std::uint8_t>(60, 255));
    EXPECT_EQ(pixels("/picture.png"), std::vector<std::uint8_t>(60, 99)) << "what was asked for before does not stay";
}

/// The render makes pictures only when they are wanted, and who wants one gets it.
TEST(Web, APictureIsMadeForWhoAsks) {
    WebViewer viewer(0);
    viewer.show(test_state(grey(0.125f)));
    EXPECT_FALSE(viewer.wants_picture());
    std::thread render([&] {
        while (!viewer.wants_picture()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        viewer.show(test_state(grey(0.5f)));
    });
    const auto answer = client_of(viewer).Get("/picture.png");
    render.join();
    EXPECT_EQ(decode(answer->body, 5, 4), std::vector<std::uint8_t>(60, 188));
    EXPECT_FALSE(viewer.wants_picture());
}

TEST(Web, BeforeTheFirstPictureThereIsNone) {
    const WebViewer viewer(0);
    EXPECT_EQ(client_of(viewer).Get("/picture.png")->status, 503);
}

TEST(Web, AnswersBadRequestsAndNothingElse) {
    WebViewer viewer(0);
    viewer.show(test_state(grey(1), PreviewPhase::done));
    httplib::Client client = client_of(viewer);
    for (const char *path : {"/nothing", "/state.json/", "/../etc/passwd", "//", "/picture.png/1"}) EXPECT_EQ(client.Get(path)->status, 404) << path;
    for (const char *exposure : {"x", "", "1e9", "nan", "inf", "1;2", "--1"})
        EXPECT_EQ(client.Get(std::string("/picture.png?exposure=") + exposure)->status, 400) << exposure;
    EXPECT_EQ(client.Post("/state.json", "{}", "application/json")->status, 405);
    EXPECT_EQ(client.Delete("/picture.png")->status, 405);
    EXPECT_EQ(client.Get("/" + std::string(100000, 'a'))->status, 414);
    EXPECT_EQ(client.Get("/state.json")->status, 200) << "and the next one is answered as ever";
}

TEST(Web, APortThatIsTakenIsAnError) {
    const WebViewer first(0);
    const int port = port_of(first);
    try {
        const WebViewer second(port);
        FAIL() << "both listen";
    } catch (const SceneError &error) {
        EXPECT_EQ(std::string(error.what()), "--preview: cannot listen at 127.0.0.1:" + std::to_string(port) + ": Address already in use");
    }
}

TEST(Web, IsWatchedWhileAPageAsks) {
    const WebViewer viewer(0);
    EXPECT_FALSE(viewer.watched());
    client_of(viewer).Get("/");
    EXPECT_FALSE(viewer.watched()) << "the page asks for the state";
    client_of(viewer).Get("/state.json");
    EXPECT_TRUE(viewer.watched());
}

/// A connection that says nothing does not keep the program from ending.
TEST(Web, EndsAtOnceWithIdleConnections) {
    auto viewer = std::make_unique<WebViewer>(0);
    const int idle = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET, address.sin_port = htons(static_cast<std::uint16_t>(port_of(*viewer)));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(connect(idle, reinterpret_cast<sockaddr *>(&address), sizeof address), 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const auto start = std::chrono::steady_clock::now();
    viewer.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));
    close(idle);
}

}  // namespace
}  // namespace brandung
