/// brandung compare: what it prints, writes and returns.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/image.h"
#include "tests/tools/program.h"

namespace {

using namespace brandung;
using nlohmann::json;

/// A picture of 20 x 16 pixels, grey but for one pixel; its path.
std::string picture(const TemporaryFolder &folder, const std::string &name, float grey, float one_pixel) {
    Picture picture{20, 16, std::vector<vec3>(20 * 16, vec3(grey)), {}};
    picture.pixels[20 * 3 + 7] = vec3(one_pixel);
    write_picture(folder.path(name), picture);
    return folder.path(name);
}

Finished compare(const std::string &test, const std::string &reference, const std::vector<std::string> &options = {}) {
    std::vector<std::string> arguments = {"compare", test, reference};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
}

json compare_as_json(const std::string &test, const std::string &reference, std::vector<std::string> options = {}) {
    options.push_back("--json");
    const Finished run = compare(test, reference, options);
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out);
}

/// One pixel of 320 is 3 instead of 1: mse is 4 / 320, of a peak of 3.
TEST(CliCompare, JsonHasEveryMeasureAndItsPlaces) {
    const TemporaryFolder folder;
    const std::string a = picture(folder, "a.exr", 1, 3), b = picture(folder, "b.exr", 1, 1);
    const json result = compare_as_json(a, b), measures = result.at("measures");
    EXPECT_EQ(result.at("test"), a);
    EXPECT_EQ(result.at("reference"), b);
    EXPECT_EQ(result.at("width"), 20);
    EXPECT_EQ(result.at("height"), 16);
    EXPECT_EQ(result.at("range"), "hdr");
    EXPECT_NEAR(measures.at("mse").get<double>(), 4.0 / 320, 1e-12);
    EXPECT_NEAR(measures.at("relmse").get<double>(), 4.0 / 1.01 / 320, 1e-12);
    EXPECT_NEAR(measures.at("mape").get<double>(), 2.0 / 1.01 / 320, 1e-12);
    EXPECT_NEAR(measures.at("psnr").get<double>(), 10 * std::log10(9 / (4.0 / 320)), 1e-9);
    EXPECT_NEAR(measures.at("worst_block").get<double>(), 4.0 / 1.01 / 256, 1e-12);
    EXPECT_EQ(measures.at("max_error"), 2);
    EXPECT_EQ(measures.at("not_finite"), 0);
    EXPECT_EQ(measures.at("ssim"), 1) << "1 and 3 are both shown as white";
    EXPECT_GT(measures.at("flip").get<double>(), 0);
    EXPECT_EQ(result.at("psnr_peak"), 3);
    EXPECT_EQ(result.at("max_error_at"), (json{{"x", 7}, {"y", 3}, {"channel", "r"}}));
    EXPECT_EQ(result.at("worst_block_at"), (json{{"x", 0}, {"y", 0}, {"width", 16}, {"height", 16}}));
    EXPECT_EQ(result.at("means").at("reference"), (json{1.0, 1.0, 1.0}));
    EXPECT_EQ(result.at("not_finite"), (json{{"test", 0}, {"reference", 0}}));
    EXPECT_GE(result.at("flip_exposures").at("count"), 2);
}

TEST(CliCompare, TextHasALineForEveryMeasure) {
    const TemporaryFolder folder;
    const Finished run = compare(picture(folder, "a.png", 0.5f, 1), picture(folder, "b.png", 0.5f, 0));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    for (const char *line : {"\nmse ", "\nrelmse ", "\nmape ", "\npsnr ", "\nssim ", "\nflip ", "\nmax_error   1 ", "\nworst_block ",
                             "\nnot_finite  0 ", "(7, 3)", "LDR", "mean of a:"})
        EXPECT_NE(run.out.find(line), std::string::npos) << line << " in\n" << run.out;
}

TEST(CliCompare, EqualPicturesHaveNoErrorAndAnInfinitePsnr) {
    const TemporaryFolder folder;
    const std::string a = picture(folder, "a.png", 0.5f, 1);
    const json measures = compare_as_json(a, a, {"--tolerance", "mse=0", "--tolerance", "psnr=100", "--tolerance", "ssim=1"}).at("measures");
    for (const char *name : {"mse", "relmse", "mape", "flip", "max_error", "worst_block"}) EXPECT_EQ(measures.at(name), 0) << name;
    EXPECT_TRUE(measures.at("psnr").is_null());
}

/// The files' types decide, in any mixture linear light, unless an option does. White is 1 and 0.5 is 0.735 as it is stored.
TEST(CliCompare, ComparesWhatTheFilesStore) {
    const TemporaryFolder folder;
    const std::string png = picture(folder, "a.png", 1, 0.5f), white_png = picture(folder, "b.png", 1, 1), exr = picture(folder, "b.exr", 1, 1);
    const auto greatest = [](const json &result) { return result.at("measures").at("max_error").get<double>(); };
    EXPECT_NEAR(greatest(compare_as_json(png, white_png)), 1 - 188.0 / 255, 1e-6);
    EXPECT_NEAR(greatest(compare_as_json(png, exr)), 0.5, 0.003);
    EXPECT_NEAR(greatest(compare_as_json(png, white_png, {"--hdr"})), 0.5, 0.003);
    EXPECT_NEAR(greatest(compare_as_json(png, exr, {"--ldr"})), 1 - 188.0 / 255, 1e-6);
    EXPECT_EQ(compare_as_json(png, exr).at("range"), "hdr");
    EXPECT_EQ(compare_as_json(png, exr, {"--ldr"}).at("range"), "ldr");
}

TEST(CliCompare, BeyondAToleranceTheStatusIsThree) {
    const TemporaryFolder folder;
    const std::string a = picture(folder, "a.exr", 1, 3), b = picture(folder, "b.exr", 1, 1);
    EXPECT_EQ(compare(a, b, {"--tolerance", "mse=0.0126", "--tolerance", "psnr=28"}).status, 0);
    const Finished error = compare(a, b, {"--tolerance", "mse=0.0124", "--tolerance", "flip=1"});
    EXPECT_EQ(error.status, 3);
    EXPECT_EQ(error.err, "beyond tolerance: mse is 0.0125, more than 0.0124\n");
    EXPECT_NE(error.out, "") << "the measures are printed all the same";
    const Finished likeness = compare(a, b, {"--tolerance", "psnr=29"});  // 10 log10(9 / 0.0125) = 28.57
    EXPECT_EQ(likeness.status, 3);
    EXPECT_EQ(likeness.err, "beyond tolerance: psnr is 28.5733, less than 29\n");
}

TEST(CliCompare, PixelsThatAreNotFiniteAreCountedAndBeyondAnyToleranceButTheirOwn) {
    const TemporaryFolder folder;
    const std::string a = picture(folder, "a.exr", 1, NAN), b = picture(folder, "b.exr", 1, 1);
    const json result = compare_as_json(a, b);
    EXPECT_EQ(result.at("measures").at("not_finite"), 1);
    EXPECT_EQ(result.at("not_finite"), (json{{"test", 1}, {"reference", 0}}));
    EXPECT_EQ(result.at("measures").at("mse"), 0);
    EXPECT_EQ(result.at("measures").at("flip"), 0);
    EXPECT_EQ(compare(a, b, {"--tolerance", "mse=1"}).status, 3);
    EXPECT_EQ(compare(a, b, {"--tolerance", "mse=1", "--tolerance", "not_finite=1"}).status, 0);
}

/// Black where the pictures are equal, light where they are not, green where there is nothing to compare.
TEST(CliCompare, DiffIsAPictureOfTheDifference) {
    const TemporaryFolder folder;
    const std::string a = picture(folder, "a.exr", 0, 1), b = picture(folder, "b.exr", 0, 0), diff = folder.path("diff.exr");
    EXPECT_EQ(compare(a, b, {"--diff", diff, "--tolerance", "mse=0"}).status, 3) << "it is written beyond tolerance too";
    const Picture difference = read_picture(diff);
    EXPECT_EQ(difference.width, 20u);
    EXPECT_LT(difference.pixels[20 * 15 + 19].y, 0.01f);
    EXPECT_GT(difference.pixels[20 * 3 + 7].x, 0.5f);
    EXPECT_EQ(compare(picture(folder, "c.exr", 0, INFINITY), b, {"--diff", diff}).status, 0);
    EXPECT_EQ(read_picture(diff).pixels[20 * 3 + 7], vec3(0, 1, 0));
}

TEST(CliCompare, WhatCannotBeComparedIsRefusedInOneLine) {
    const TemporaryFolder folder;
    const std::string a = picture(folder, "a.png", 1, 1), missing = folder.path("missing.png"), small = folder.path("small.png");
    write_picture(small, Picture{2, 3, std::vector<vec3>(6, vec3(1)), {}});
    const auto refusal = [](const Finished &run, int status) {
        EXPECT_EQ(run.status, status) << run.err;
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
        return run.err;
    };
    EXPECT_EQ(refusal(compare(a, small), 1),
              "brandung: " + a + ", " + small + ": pictures of 20 x 16 and 2 x 3 pixels cannot be compared: the sizes differ\n");
    EXPECT_TRUE(refusal(compare(a, missing), 1).starts_with("brandung: " + missing + ": "));
    EXPECT_TRUE(refusal(compare(a, folder.write("text.png", "no picture")), 1).starts_with("brandung: " + folder.path("text.png") + ": "));
    EXPECT_NE(refusal(compare(small, small, {"--tolerance", "ssim=0.5"}), 1).find("ssim has no value"), std::string::npos);
    EXPECT_NE(refusal(compare(a, a, {"--diff", folder.path("none/diff.png")}), 1).find("none/diff.png: cannot write there"), std::string::npos);
    EXPECT_NE(refusal(compare(a, a, {"--tolerance", "beauty=1"}), 2).find("no measure 'beauty'"), std::string::npos);
    for (const char *tolerance : {"mse", "mse=", "mse=1x", "mse=nan"}) refusal(compare(a, a, {"--tolerance", tolerance}), 2);
    refusal(compare(a, a, {"--ldr", "--hdr"}), 2);
    for (const char *ppd : {"0", "nan", "inf", "1001"})
        EXPECT_NE(refusal(compare(a, a, {"--ppd", ppd}), 2).find("must be from 1 to 1000, got '"), std::string::npos);
}

TEST(CliCompare, HelpNamesEveryOptionAndMeasure) {
    const Finished run = run_program({"compare", "--help"});
    EXPECT_EQ(run.status, 0);
    for (const char *word : {"--diff", "--tolerance", "--ldr", "--hdr", "--ppd", "--json", "mse, relmse, mape, psnr, ssim, flip"})
        EXPECT_NE(run.out.find(word), std::string::npos) << word;
}

}  // namespace
