/// brandung converge.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

/// Runs `brandung converge SCENE --size 24x16 ARGUMENTS...` on native_scene().
Finished converge(const TemporaryFolder &folder, const std::vector<std::string> &more) {
    std::vector<std::string> arguments = {"converge", folder.write("scene.json", native_scene()), "--size", "24x16", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
}

/// The same with a reference of its own, interrupted as soon as it has said `line`.
Finished interrupted_converge(const TemporaryFolder &folder, const std::string &line, const std::vector<std::string> &more) {
    std::vector<std::string> arguments = {"converge", folder.write("scene.json", native_scene()), "--size", "24x16", "--reference", "auto"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments, {.signal_when = [&](const std::string &err) { return err.find(line) != std::string::npos ? SIGINT : 0; }});
}

}  // namespace

TEST(CliConverge, FollowsTheErrorOfEverySeries) {
    const TemporaryFolder folder;
    const std::string page = folder.path("page.html"), csv = folder.path("runs.csv");
    const Finished run = converge(folder, {"--reference", "auto", "--samples", "2,8,32", "--seeds", "3", "--vary", "film.sampler=sobol,independent",
                                           "--html", page, "--csv", csv, "--json"});
    expect_success(run);
    const json result = json::parse(run.out);
    ASSERT_EQ(result.at("series").size(), 2u);
    EXPECT_EQ(result.at("interrupted"), false);
    EXPECT_GT(result.at("reference_noise"), 0);
    for (const json &series : result.at("series")) {
        ASSERT_EQ(series.at("rungs").size(), 3u);
        EXPECT_EQ(series.at("runs").size(), 9u);
        for (std::size_t i = 0; i < 3; ++i) {
            const json &rung = series.at("rungs")[i];
            EXPECT_EQ(rung.at("samples"), std::vector<double>({2, 8, 32})[i]);
            EXPECT_EQ(rung.at("runs"), 3);
            EXPECT_LE(rung.at("errors").at("mse").at("low"), rung.at("errors").at("mse").at("mean"));
        }
        EXPECT_LT(series.at("rungs")[2].at("errors").at("mse").at("mean"), series.at("rungs")[0].at("errors").at("mse").at("mean"));
    }
    // Independent samples' errors fall with their number; 5 standard errors beside.
    const json fit = result.at("series")[1].at("fits").at("mse").at("by_samples");
    EXPECT_NEAR(fit.at("slope").get<double>(), -1, 5 * fit.at("standard_error").get<double>());

    const std::string html = read_file(page), table = read_file(csv);
    EXPECT_NE(html.find("\"sampler=independent\""), std::string::npos);
    EXPECT_EQ(result.at("series")[0].at("way").at("settings").at("sampler"), "sobol");
    EXPECT_EQ(result.at("series")[0].at("way").at("departures"), json::array());
    EXPECT_EQ(result.at("warnings"), json::array()) << "16 times the samples are enough";
    EXPECT_EQ(run.err, "") << "nor anything else to say";
    for (const char *outside : {"src=", "href=", "http://www.w3.org/2000/svg\" rel", "@import", "fetch("})
        EXPECT_EQ(html.find(outside), std::string::npos);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 18);
}

/// A second rung of hours, interrupted once the first is measured.
TEST(CliConverge, InterruptedReportsWhatWasMeasured) {
    const TemporaryFolder folder;
    const std::string page = folder.path("page.html"), csv = folder.path("runs.csv");
    const Finished run = interrupted_converge(folder, "rung 1 of 2 is measured\n",
                                              {"--samples", "2,16777216", "--seeds", "3", "--reference-spp", "16", "--vary",
                                               "film.sampler=sobol,independent", "--html", page, "--csv", csv, "--json"});
    EXPECT_EQ(run.status, 130) << "signal " << run.signal << run.err;
    const json result = json::parse(run.out);
    EXPECT_EQ(result.at("interrupted"), true);
    EXPECT_EQ(result.at("runs_done"), 6);
    EXPECT_EQ(result.at("runs_total"), 12);
    ASSERT_EQ(result.at("series").size(), 2u);
    for (const json &series : result.at("series")) {
        ASSERT_EQ(series.at("rungs").size(), 1u);
        EXPECT_EQ(series.at("rungs")[0].at("runs"), 3);
    }
    const std::string table = read_file(csv), html = read_file(page);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 6);
    EXPECT_NE(html.find("\"runs_done\":6"), std::string::npos);
}

TEST(CliConverge, InterruptedBeforeTheFirstRunWritesNothing) {
    const TemporaryFolder folder;
    const Finished run = interrupted_converge(folder, "reference: 0 %\n",
                                              {"--samples", "2", "--reference-spp", "16777216", "--csv", folder.path("runs.csv"), "--json"});
    EXPECT_EQ(run.status, 130) << "signal " << run.signal << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.json"});
    EXPECT_NE(run.err.find("interrupted: nothing was measured\n"), std::string::npos) << run.err;
}

/// A first rung of hours: the reference is written by then.
TEST(CliConverge, InterruptedAfterTheReferenceNamesIt) {
    const TemporaryFolder folder;
    const std::string saved = folder.path("reference.exr");
    const Finished run = interrupted_converge(folder, "rung 1 of 1, repetition 1 of 4: 0 %\n",
                                              {"--samples", "16777216", "--reference-spp", "2", "--save-reference", saved, "--json"});
    EXPECT_EQ(run.status, 130) << "signal " << run.signal << run.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"reference.exr", "scene.json"}));
    EXPECT_NE(run.err.find("interrupted: nothing was measured; the reference is written to " + saved + "\n"), std::string::npos) << run.err;
}

/// Parts of as many pixels: those of another place are refused, of another size of the whole too, and before anything is rendered where ways differ.
TEST(CliConverge, RefusesAReferenceOfAnotherPart) {
    const TemporaryFolder folder;
    const std::string saved = folder.path("reference.exr");
    const auto with = [&](const std::vector<std::string> &more) {
        std::vector<std::string> arguments = {"--samples", "2", "--seeds", "1", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return converge(folder, arguments);
    };
    expect_success(with({"--crop", "0,0,8,8", "--reference", "auto", "--save-reference", saved}));
    expect_success(with({"--crop", "0,0,8,8", "--reference", saved}));
    const Finished moved = with({"--crop", "8,8,16,16", "--reference", saved});
    EXPECT_EQ(moved.status, 1);
    EXPECT_EQ(moved.err, "brandung: " + saved + ": shows pixels 0,0,8,8 of 24 x 16, but brandung those 8,8,16,16 of 24 x 16\n");
    const Finished smaller = run_program({"converge", folder.path("scene.json"), "--size", "8x8", "--quiet", "--reference", saved});
    EXPECT_EQ(smaller.status, 1);
    EXPECT_NE(smaller.err.find("0,0,8,8 of 24 x 16, but brandung those 0,0,8,8 of 8 x 8\n"), std::string::npos) << smaller.err;
    const Finished varied = with({"--reference", "auto", "--vary", "film.crop=[0,0,8,8],[8,8,16,16]"});
    EXPECT_EQ(varied.status, 1);
    EXPECT_NE(varied.err.find("crop=[0,0,8,8]: shows pixels 0,0,8,8 of 24 x 16, but crop=[8,8,16,16] those 8,8,16,16"), std::string::npos)
        << varied.err;
}

/// The pictures of another program are measured against the same reference: it is given here, and one of them is itself. They are listed from the
/// best to the worst, and their rungs come out from the worst to the best.
TEST(CliConverge, TakesSeriesOfOtherRenderers) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    std::filesystem::create_directory(folder.path("other"));
    for (const auto &[file, spp] : {std::pair{"reference.exr", "64"}, {"other/a.exr", "2"}, {"other/b.exr", "8"}, {"small.exr", "1"}})
        render_quietly({scene, "--size", *spp == '1' ? "8x8" : "24x16", "--spp", spp, "-o", folder.path(file)});
    folder.write("other/times.json", R"([{"file": "../reference.exr", "seconds": 9, "samples": 64}, {"file": "b.exr", "seconds": 2, "samples": 8},
        {"file": "a.exr", "seconds": 0.5, "samples": 2}])");
    const Finished run = converge(folder, {"--reference", folder.path("reference.exr"), "--samples", "1", "--seeds", "1", "--series",
                                           "other=" + folder.path("other"), "--json"});
    expect_success(run);
    const json result = json::parse(run.out), &other = result.at("series").at(1);
    EXPECT_EQ(other.at("name"), "other");
    ASSERT_EQ(other.at("rungs").size(), 3u);
    EXPECT_EQ(other.at("rungs")[0].at("samples"), 2);
    EXPECT_EQ(other.at("runs")[1].at("samples"), 8);
    EXPECT_GT(other.at("runs")[0].at("mse"), other.at("runs")[1].at("mse"));
    EXPECT_EQ(other.at("runs")[2].at("mse"), 0);
    EXPECT_FALSE(result.at("reference_noise").is_null()) << "render has written it";
    EXPECT_EQ(other.at("way"), nullptr);

    folder.write("other/times.json", R"([{"file": "../small.exr", "seconds": 1}])");
    const Finished wrong = converge(folder, {"--reference", "auto", "--series", "other=" + folder.path("other")});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_EQ(wrong.err, "brandung: " + folder.path("other/../small.exr") + ": has 8 x 8 pixels, not 24 x 16\n") << "and nothing was rendered before";
}

/// A mirror, so that a depth of 1 ends rays: it converges to another picture than the reference, whose settings are chosen.
TEST(CliConverge, WarnsOfWaysThatConvergeToSomethingElse) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    const std::vector<std::string> base = {"converge", scene,           "--size", "24x16",  "--quiet", "--samples",
                                           "2",        "--seeds",       "1",      "--json", "--set",   "materials.0.reflection=0.5",
                                           "--set",    "background=0.3"};
    const auto with = [&](const std::vector<std::string> &more) {
        std::vector<std::string> arguments = base;
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished run = run_program(arguments);
        expect_success(run);
        return std::pair{json::parse(run.out), run.err};
    };
    const std::string saved = folder.path("reference.exr");
    const auto [first, first_err] = with({"--reference", "auto", "--reference-set", "integrator.max_depth=3", "--vary", "integrator.max_depth=1,2",
                                          "--reference-spp", "32", "--save-reference", saved});
    EXPECT_EQ(first.at("reference"), "32 spp of integrator.max_depth=3");
    const std::string warning = "max_depth=1 converges to another picture than the reference: max_depth 1, not 3; its errors are that difference too";
    EXPECT_EQ(first.at("warnings"), json::array({warning})) << "rays end after one mirror";
    EXPECT_EQ(first_err, "warning: " + warning + "\n");
    EXPECT_EQ(first.at("series")[0].at("way").at("biased_by")[0].at("name"), "depth limit");
    EXPECT_EQ(first.at("series")[0].at("way").at("departures")[0], json({{"setting", "max_depth"}, {"own", "1"}, {"other", "3"}}));
    // The same picture again, from a file that says what it was made from.
    const auto [second, second_err] = with({"--reference", saved, "--vary", "integrator.max_depth=1,2"});
    EXPECT_EQ(second.at("warnings"), first.at("warnings"));
    EXPECT_NEAR(second.at("reference_noise").get<double>() / first.at("reference_noise").get<double>(), 1, 1e-5);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(second.at("series")[i].at("runs")[0].at("mse"), first.at("series")[i].at("runs")[0].at("mse")) << "the same reference, to the bit";
}

/// A reference of two samples is hardly better than what is measured.
TEST(CliConverge, WarnsOfANoisyReference) {
    const TemporaryFolder folder;
    const Finished run = converge(folder, {"--reference", "auto", "--reference-spp", "2", "--samples", "2,4", "--seeds", "1", "--json"});
    expect_success(run);
    const json result = json::parse(run.out);
    for (const json &rung : result.at("series")[0].at("rungs")) EXPECT_EQ(rung.at("near_reference_noise"), true);
    EXPECT_NE(run.err.find("is more than a tenth of the relMSE of 2, 4 samples"), std::string::npos) << run.err;
    EXPECT_EQ(result.at("warnings").size(), 1u);
}

TEST(CliConverge, WhatVariesCountsMoreThanOtherOptions) {
    const TemporaryFolder folder;
    const Finished run = converge(folder, {"--reference", "auto", "--samples", "4", "--seeds", "1", "--sampler", "sobol", "--vary",
                                           "film.sampler=sobol,independent", "--json"});
    expect_success(run);
    const json series = json::parse(run.out).at("series");
    EXPECT_NE(series[0].at("rungs")[0].at("errors"), series[1].at("rungs")[0].at("errors"));
}

/// A lamp of radiance 4 is cut in a picture of integers.
TEST(CliConverge, WarnsOfAReferenceThatIsCut) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("lamp.nff", nff_scene("s 0 0 0 1\n"));
    render_quietly({scene, "--size", "24x16", "--background", "4,4,4", "-o", folder.path("cut.png"), "-o", folder.path("whole.exr")});
    const auto err_with = [&](const std::string &reference) {
        return run_program({"converge", scene, "--size", "24x16", "--background", "4,4,4", "--quiet", "--samples", "1", "--reference", reference})
            .err;
    };
    EXPECT_NE(err_with(folder.path("cut.png")).find("cut.png: nothing in this reference is brighter than 1, and "), std::string::npos);
    EXPECT_EQ(err_with(folder.path("whole.exr")).find("brighter"), std::string::npos);
}

TEST(CliConverge, RefusesWhatItCannotDo) {
    const TemporaryFolder folder;
    const auto expect_usage = [&](const std::vector<std::string> &more, const std::string &what) {
        const Finished run = converge(folder, more);
        EXPECT_EQ(run.status, 2) << run.err;
        EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
    };
    expect_usage({}, "--reference");
    expect_usage({"--reference", "auto", "--samples", "4,2"}, "--samples");
    expect_usage({"--reference", "auto", "--samples", "4,4"}, "--samples: must rise");
    expect_usage({"--reference", "auto", "--samples", "4", "--times", "1"}, "--times");
    expect_usage({"--reference", "auto", "--times", "1"}, "--reference-spp");
    expect_usage({"--reference", "auto", "--vary", "nothing"}, "--vary");
    expect_usage({"--reference", "auto", "--vary", "film.sampler=sobol,sobol"}, "two series would be called 'sampler=sobol'");
    expect_usage({"--reference", "auto", "--spp", "4"}, "--spp: is the ladder's: --samples says how many");
    expect_usage({"--reference", "auto", "--vary", "film.seed=4,5"}, "--vary: film.seed is the ladder's");
    expect_usage({"--reference", "none.exr", "--save-reference", "a.exr"}, "--save-reference: needs --reference auto");
    expect_usage({"--reference", "none.exr", "--reference-set", "film.filter=tent"}, "--reference-set: needs --reference auto");
    expect_usage({"--reference", "auto", "--samples", "2", "--seeds", "1", "--series", "nothing"}, "--series");
    const Finished unknown = converge(folder, {"--reference", "auto", "--vary", "film.sampler=none"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("film/sampler"), std::string::npos) << unknown.err;
    const Finished missing = converge(folder, {"--reference", "auto", "--samples", "2", "--seeds", "1", "--series", "a=" + folder.path("none")});
    EXPECT_EQ(missing.status, 1);
    const Finished png = converge(folder, {"--reference", "auto", "--save-reference", folder.path("a.png")});
    EXPECT_EQ(png.err, "brandung: " + folder.path("a.png") + ": must be an EXR, which keeps floats and what the reference was made from\n");
    EXPECT_NE(missing.err.find("times.json"), std::string::npos) << missing.err;
    const Finished twice = converge(folder, {"--reference", "auto", "--vary", "film.sampler=sobol", "--vary", "film.sampler=independent"});
    EXPECT_EQ(twice.status, 2);
    EXPECT_NE(twice.err.find("--vary: film.sampler is varied twice"), std::string::npos) << twice.err;
}
