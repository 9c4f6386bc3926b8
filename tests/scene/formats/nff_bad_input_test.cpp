#include <gtest/gtest.h>

#include <random>

#include "tests/scene/formats/nff_text.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

struct BadInput {
    std::string text, message;
};
void PrintTo(const BadInput &bad, std::ostream *stream) { *stream << bad.message; }

class NffBadInput : public testing::TestWithParam<BadInput> {};

TEST_P(NffBadInput, IsRefusedWithLineAndCause) { EXPECT_EQ(error_of_nff_text(GetParam().text), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Viewpoint, NffBadInput,
    testing::Values(BadInput{"# nothing\n\n", "3: the file has no viewpoint (v)"},
                    BadInput{nff_viewpoint + "b 0 0 0\n" + nff_viewpoint, "9: second viewpoint; the first is on line 1"},
                    BadInput{"v\nfrom 1 2 3\nat 0 0 0\nangle 5\nresolution 1 1\ns 0 0 0 1", "1: viewpoint: needs \"up\", found \"s\""},
                    BadInput{"v\nfrom 1 2 3\n", "1: viewpoint: needs \"at\", found the end of the file"},
                    BadInput{"v\nfrom 1 2 3\nfrom 1 2 3\n", "3: viewpoint: second \"from\""},
                    BadInput{"v\nresolution 0 10\n", "2: resolution: must be from 1 to 65535, got 0"},
                    BadInput{"v\nresolution 10 65536\n", "2: resolution: must be from 1 to 65535, got 65536"},
                    BadInput{"v\nresolution 10 -1\n", "2: resolution: must be from 1 to 65535, got -1"},
                    BadInput{"v\nresolution 10.5 1\n", "2: resolution: expected a whole number, found \"10.5\""},
                    BadInput{"v\nresolution 10 99999999999999999999\n", "2: resolution: expected a whole number, found \"99999999999999999999\""},
                    BadInput{"v\nangle 0\n", "2: angle: must be above 0 and below 180 degrees, got 0"},
                    BadInput{"v\nangle 180\n", "2: angle: must be above 0 and below 180 degrees, got 180"},
                    BadInput{"v\nat 0 0 0\nfrom 0 0 0\nup 0 0 1\nangle 60\nresolution 1 1", "1: viewpoint: \"at\" must differ from \"from\""},
                    BadInput{"v\nat 0 0 1\nfrom 0 0 0\nup 0 0 0\nangle 60\nresolution 1 1", "1: viewpoint: \"up\" must not be zero"},
                    BadInput{"v\nat 0 0 1\nfrom 0 0 0\nup 0 0 1\nangle 60\nresolution 1 1",
                             "1: viewpoint: \"up\" must not be parallel to the view from \"from\" to \"at\""}));

const char *const expected_number = ": expected a finite number in the range of a float, found ";

INSTANTIATE_TEST_SUITE_P(
    Entities, NffBadInput,
    testing::Values(BadInput{nff_viewpoint + "\nx 1 2 3\n", "9: expected one of v, b, l, f, c, s, p, pp, found \"x\""},
                    BadInput{nff_viewpoint + "s 1 2 3 4 5\n", "8: expected one of v, b, l, f, c, s, p, pp, found \"5\""},
                    BadInput{nff_viewpoint + "s 1 2 x 4\n", "8: center of a sphere" + std::string(expected_number) + "\"x\""},
                    BadInput{nff_viewpoint + "s 1 2 3x 4\n", "8: center of a sphere" + std::string(expected_number) + "\"3x\""},
                    BadInput{nff_viewpoint + "s 1 2 3\ns 1 2 3 4\n", "9: radius of a sphere" + std::string(expected_number) + "\"s\""},
                    BadInput{nff_viewpoint + "s 1 2 nan 1\n", "8: center of a sphere" + std::string(expected_number) + "\"nan\""},
                    BadInput{nff_viewpoint + "s 1 2 -inf 1\n", "8: center of a sphere" + std::string(expected_number) + "\"-inf\""},
                    BadInput{nff_viewpoint + "s 1 2 1e300 1\n", "8: center of a sphere" + std::string(expected_number) + "\"1e300\""},
                    BadInput{nff_viewpoint + "s 1 2 1e400 1\n", "8: center of a sphere" + std::string(expected_number) + "\"1e400\""},
                    BadInput{nff_viewpoint + "s 1 2 -2e15 1\n", "8: center of a sphere: must be at most 1e+15 in magnitude, got -2e+15"},
                    BadInput{nff_viewpoint + "s 1 2 3 2e15\n", "8: radius of a sphere: must be at most 1e+15 in magnitude, got 2e+15"},
                    BadInput{nff_viewpoint + "c 0 0 0 1 0 0 1 -1\n", "8: cone: radii must have the same sign, got 1 and -1"},
                    BadInput{nff_viewpoint + "c 0 0 0 1 0 0 1", "8: apex radius of a cone" + std::string(expected_number) + "the end of the file"},
                    BadInput{nff_viewpoint + "b 1 1 -1\n", "8: background: must not be negative, got -1"},
                    BadInput{nff_viewpoint + "l 1 1 1 1 1\n\n", "10: color of a light" + std::string(expected_number) + "the end of the file"},
                    BadInput{nff_viewpoint + "f 1 1 1 1 1 1 0.5 0\n", "8: index of refraction: must be positive where T is, got 0"},
                    BadInput{
                        nff_viewpoint + "f 1 1 1 1 1 1 0.5 1e9\n",
                        "8: index of refraction: must be from 0.01 to 100, got 1e+09 (ratios of indices are squared, which must fit into a float)"},
                    BadInput{nff_viewpoint + "f 1 1 1 1 -1 1 0.5 1\n", "8: Ks of a material: must not be negative, got -1"}));

INSTANTIATE_TEST_SUITE_P(
    Polygons, NffBadInput,
    testing::Values(BadInput{nff_viewpoint + "p 2\n0 0 0\n1 1 1\n", "8: polygon: needs at least 3 vertices, got 2"},
                    BadInput{nff_viewpoint + "p -3\n0 0 0\n", "8: polygon: needs at least 3 vertices, got -3"},
                    BadInput{nff_viewpoint + "p x\n0 0 0\n", "8: number of vertices: expected a whole number, found \"x\""},
                    BadInput{nff_viewpoint + "p 3\n0 0 0\n1 1 1\ns 0 0 0 1", "11: polygon of line 8: expected 3 vertices, found 2 and \"s\""},
                    BadInput{nff_viewpoint + "p 3\n0 0 0\n1 1 1\n", "11: polygon of line 8: expected 3 vertices, found 2 and the end of the file"},
                    BadInput{nff_viewpoint + "p 4000000000000\n0 0 0\n",
                             "10: polygon of line 8: expected 4000000000000 vertices, found 1 and the end of the file"},
                    BadInput{nff_viewpoint + "p 3\n0 0 0\n1 1", "10: vertex of a polygon" + std::string(expected_number) + "the end of the file"},
                    BadInput{nff_viewpoint + "p 3\n0 0 0\nNaN 1 1", "10: vertex of a polygon" + std::string(expected_number) + "\"NaN\""},
                    BadInput{nff_viewpoint + "pp 3\n0 0 0 0 0 inf\n", "9: normal of a patch" + std::string(expected_number) + "\"inf\""},
                    BadInput{nff_viewpoint + "p 3\n0 0 0\n\x1b[31m 1 1", "10: polygon of line 8: expected 3 vertices, found 1 and \"?[31m\""}));

TEST(Nff, FilesThatCannotBeReadAreRefused) {
    EXPECT_THROW(read_scene("/nowhere/scene.nff"), SceneError);
    EXPECT_NE(error_of_nff_text(""), "");
    const fs::path folder = fs::temp_directory_path() / fmt::format("brandung_nff_test_folder_{}.nff", getpid());
    fs::create_directory(folder);
    EXPECT_THROW(read_scene(folder.string()), SceneError);
    fs::remove(folder);
}

TEST(Nff, TruncatedAnywhereIsReadOrRefused) {
    uint read_whole = 0;
    for (std::size_t bytes = 0; bytes < good_nff.size(); ++bytes) read_whole += error_of_nff_text(good_nff.substr(0, bytes)).empty();
    EXPECT_GT(read_whole, 0u);
    EXPECT_LT(read_whole, good_nff.size() / 2);
}

TEST(Nff, RandomBytesAreReadOrRefused) {
    std::mt19937 random(1);
    for (int round = 0; round < 300; ++round) {
        std::string noise(random() % 400, ' ');
        for (char &c : noise) c = char(random());
        EXPECT_NE(error_of_nff_text(noise), "");
        // A good file with a few bytes changed.
        std::string changed = good_nff;
        for (int i = 0; i < 3; ++i) changed[random() % changed.size()] = round % 2 ? char(random()) : "0123456789.-e \n#spcfl"[random() % 21];
        error_of_nff_text(changed);
    }
}

}  // namespace
}  // namespace brandung
