/// Filters, parts and tones of pictures in scene files.
#include <gtest/gtest.h>

#include "scene/filters/filter.h"
#include "scene/formats/format.h"
#include "scene/tone.h"
#include "tests/scene/formats/native_text.h"

namespace brandung {
namespace {

const char *const plain_scene = R"({"film": {"width": 64, "height": 48, "spp": 4}, "camera": {"from": [0, 0, 5], "at": [0, 0, 0]}})";

}  // namespace

TEST(FilmSettings, FiltersHaveRadiiOfTheirOwn) {
    const auto radius = [](const std::string &filter, const std::string &more = "film.seed=1") {
        const FilmSettings film = read_text(plain_scene, {"film.filter=" + filter, more}).film;
        EXPECT_EQ(filter_kinds()[film.filter].name, filter);
        return film.filter_radius;
    };
    EXPECT_EQ(radius("box"), 0.5f);
    EXPECT_EQ(radius("tent"), 1.0f);
    EXPECT_EQ(radius("gaussian"), 1.5f);
    EXPECT_EQ(radius("mitchell"), 2.0f);
    EXPECT_EQ(radius("blackman_harris"), 1.5f);
    EXPECT_EQ(radius("gaussian", "film.filter_radius=2.5"), 2.5f);
    EXPECT_EQ(error_of_text(plain_scene, {"film.filter=lanczos"}),
              ": /film/filter (set on the command line): must be one of box, tent, gaussian, mitchell, blackman_harris, got \"lanczos\"");
    EXPECT_EQ(error_of_text(plain_scene, {"film.filter_radius=2"}),
              ": /film/filter_radius (set on the command line): the box is the pixel itself and takes no radius");
    EXPECT_EQ(error_of_text(plain_scene, {"film.filter=tent", "film.filter_radius=101"}),
              ": /film/filter_radius (set on the command line): must be at most 100 pixels, got 101");
    EXPECT_EQ(error_of_text(plain_scene, {"film.filter=tent", "film.spp=1", "film.pixel=corner"}),
              ": /film/filter (set on the command line): pixels at corners take no filter but the box");
    EXPECT_EQ(error_of_text(plain_scene, {"film.filter=mitchell", "film.splat=true"}),
              ": /film/splat (set on the command line): needs a filter that is nowhere negative, since the weights of few samples of mitchell may "
              "sum up to nothing");
    for (const char *radius : {"5", "0.49"})
        EXPECT_EQ(
            error_of_text(plain_scene, {"film.filter=tent", std::string("film.filter_radius=") + radius, "film.splat=true"}),
            std::string(": /film/filter_radius (set on the command line): must be from 0.5 to 4 pixels where samples are splatted, got ") + radius);
    EXPECT_TRUE(read_text(plain_scene, {"film.filter=tent", "film.filter_radius=0.5", "film.splat=true"}).film.splat);
}

TEST(FilmSettings, WarnOfSplatsOfTheBox) {
    const auto warnings = [](const std::vector<std::string> &options) { return read_text(plain_scene, options).warning_places; };
    const std::map<std::string, std::string> found = warnings({"film.splat=true"}), before = warnings({});
    ASSERT_EQ(found.size(), before.size() + 1);
    EXPECT_TRUE(found.at("film.splat has no effect with the filter box").ends_with(".json: /film/splat (set on the command line)"));
    EXPECT_EQ(warnings({"film.splat=true", "film.filter=tent"}), before);
    EXPECT_EQ(warnings({"film.splat=false"}), before);
}

TEST(FilmSettings, ReadsCropExposureAndTone) {
    const FilmSettings film = read_text(plain_scene, {"film.crop=[1,2,64,48]", "film.exposure=auto", "film.tone=filmic"}).film;
    EXPECT_EQ(film.window(), (Window{1, 2, 64, 48}));
    EXPECT_TRUE(film.automatic_exposure);
    EXPECT_EQ(tone_kinds()[film.tone].name, std::string("filmic"));
    EXPECT_EQ(read_text(plain_scene).film.window(), (Window{0, 0, 64, 48}));
    const auto error = [](const std::string &setting) { return error_of_text(plain_scene, {"film." + setting}); };
    EXPECT_EQ(error("crop=[1,2,3]"), ": /film/crop (set on the command line): must be an array of 4 numbers, got one of 3");
    EXPECT_EQ(error("crop=[1,2,1,4]"), ": /film/crop (set on the command line): has no pixels: must be X0, Y0, X1, Y1 with X0 < X1 and Y0 < Y1");
    EXPECT_EQ(error("crop=[1,2,65,4]"), ": /film/crop (set on the command line): reaches beyond the picture of 64 x 48 pixels");
    EXPECT_EQ(error("exposure=manual"), ": /film/exposure (set on the command line): must be a number or \"auto\", got \"manual\"");
    EXPECT_EQ(error("tone=film"), ": /film/tone (set on the command line): must be one of srgb, filmic, none, got \"film\"");
}

}  // namespace brandung
