/// brandung selftest: verdicts, exit status, and what render makes of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/tools/bad_input.h"
#include "tests/tools/program.h"
#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

namespace fs = std::filesystem;

/// A cache folder of its own, and kernels that can be changed.
class SelfTest : public testing::Test {
protected:
    /// Replaces a part of a kernel file, which must be there, from now on.
    void plant(const std::string &file, const std::string &right, const std::string &wrong) {
        if (!fs::exists(folder.path("kernels"))) fs::copy(BRANDUNG_SOURCE_DIR "/kernels", folder.path("kernels"), fs::copy_options::recursive);
        std::string text = read_file(folder.path("kernels/" + file));
        const auto place = text.find(right);
        ASSERT_NE(place, std::string::npos) << right << " in " << file;
        folder.write("kernels/" + file, text.replace(place, right.size(), wrong));
        options.environment["KERNEL_DIR"] = folder.path("kernels");
    }
    Finished selftest(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"selftest", "--quiet"});
        return run_program(arguments, options);
    }
    Finished render(std::vector<std::string> arguments = {}) const {
        arguments.insert(arguments.begin(),
                         {"render", folder.write("scene.json", native_scene()), "--quiet", "--size", "8x8", "-o", folder.path("picture.exr")});
        return run_program(arguments, options);
    }

    TemporaryFolder folder;
    RunOptions options{.environment = {{"XDG_CACHE_HOME", folder.path("cache")}}, .signal_when = {}, .out_file = {}};
};

TEST_F(SelfTest, AGoodDevicePassesAndTheTableSaysWhatWasSeen) {
    const Finished run = selftest({"--only", "sphere,next_up", "--json"});
    expect_success(run);
    EXPECT_EQ(run.err, "");
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(report["verdict"], "incomplete") << "of all subjects these are two";
    EXPECT_FALSE(report["passed"]);
    EXPECT_TRUE(report["subjects"][0]["passed"]);
    EXPECT_TRUE(report["subjects"][0]["complete"]);
    ASSERT_EQ(report["subjects"].size(), 2u);
    const auto &sphere = report["subjects"][1];
    EXPECT_EQ(sphere["name"], "sphere");
    EXPECT_GE(sphere["inputs"], 300'000);
    EXPECT_GT(sphere["hits"], sphere["inputs"].get<int>() / 4);
    EXPECT_LT(sphere["ambiguous"], sphere["inputs"].get<int>() / 2);
    for (const char *quantity : {"t", "position", "normal"}) {
        const auto &errors = sphere["errors"][quantity];
        EXPECT_GT(errors["well_conditioned"], sphere["hits"].get<int>() / 4) << quantity;
        EXPECT_GT(errors["mean_ulps"], 0) << quantity;
        EXPECT_LE(errors["max_of_bound"], 1) << quantity;
        EXPECT_EQ(errors["count"].get<int>() + errors["unknown"].get<int>(), sphere["hits"]) << quantity << ": what is left out is told";
        if (!report["device"]["doubles"]) continue;
        // Rounding is most of the errors: the formulas are right.
        EXPECT_GT(errors["rounding"]["mean_ulps"], 0.5 * errors["mean_ulps"].get<double>()) << quantity;
        EXPECT_LT(errors["rounding"]["mean_ulps"], 1.5 * errors["mean_ulps"].get<double>()) << quantity;
    }
}

TEST_F(SelfTest, APartIsNoPassAndDevicesSaysWhatIsKnown) {
    const auto devices = [&](const std::string &option = "") {
        return run_program(option.empty() ? std::vector<std::string>{"devices"} : std::vector{std::string("devices"), option}, options).out;
    };
    EXPECT_NE(devices().find("| selftest: never tried\n"), std::string::npos);
    const Finished run = selftest({"--only", "next_up"});
    expect_success(run);
    EXPECT_NE(run.out.find("\nINCOMPLETE: nothing has failed, of "), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("\npassed"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("\nambiguous  decisions"), std::string::npos) << "the table has a legend";
    EXPECT_NE(devices().find("| selftest: incomplete, a part passed on 20"), std::string::npos) << devices();
    EXPECT_EQ(nlohmann::json::parse(devices("--json"))[0]["selftest"]["verdict"], "incomplete");

    plant("core/math.cl", "bits + 1u : bits - 1u", "bits + 2u : bits - 1u");
    EXPECT_EQ(selftest({"--only", "next_up"}).status, 3);
    EXPECT_NE(devices().find("next_up (kernels core/math.cl)\n"), std::string::npos) << devices();
    const auto known = nlohmann::json::parse(devices("--json"))[0]["selftest"];
    EXPECT_EQ(known["verdict"], "failed");
    EXPECT_EQ(known["failed"], "next_up (kernels core/math.cl)");
}

/// Once a kernel is being compiled, signals are listened to.
TEST_F(SelfTest, AnInterruptedRunIsIncomplete) {
    const std::string cache = folder.path("pocl");
    fs::create_directory(cache);
    options.environment["POCL_CACHE_DIR"] = cache;
    options.signal_when = [&](const std::string &) {
        const fs::recursive_directory_iterator files(cache);
        return std::any_of(begin(files), end(files), [](const fs::path &file) { return file.extension() == ".bc"; }) ? SIGINT : 0;
    };
    const Finished run = selftest({"--only", "next_up", "--long", "100", "--json"});
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_EQ(nlohmann::json::parse(run.out)["verdict"], "incomplete");
}

/// The farther root where the nearer one is in front: no rounding explains that.
TEST_F(SelfTest, AKernelThatIsWrongIsNamedAndRenderRefusesTheDevice) {
    plant("primitives/sphere_hit.cl", "where((near > 0.0f) & (radius > 0.0f), near, far)", "where((near > 1.0f) & (radius > 0.0f), near, far)");
    const Finished run = selftest({"--only", "sphere,next_up"});
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.out.find("FAILED"), std::string::npos);
    EXPECT_TRUE(run.err.starts_with("sphere (primitives/sphere_hit.cl, sphere.cl): overlooked t = ")) << run.err;

    expect_failure(render(), 1, {"has failed brandung selftest: sphere (kernels primitives/sphere_hit.cl, sphere.cl)", "--untrusted-device"});
    const Finished taken = render({"--untrusted-device"});
    EXPECT_EQ(taken.status, 0) << taken.err;
    EXPECT_NE(taken.err.find("has failed brandung selftest: sphere"), std::string::npos) << taken.err;
    options.environment.erase("KERNEL_DIR");
    expect_success(render());  // those kernels are not known to be wrong
}

/// A compiler that makes one operation of two, against the source's word.
TEST_F(SelfTest, ContractionIsFound) {
    plant("core/portable.h", "FP_CONTRACT OFF", "FP_CONTRACT ON");
    const Finished run = selftest({"--only", "multiply_then_add"});
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(run.err.starts_with("multiply_then_add (core/portable.h): ")) << run.err;
}

TEST_F(SelfTest, APassForgetsAFailureOfTheSameSubjectOnly) {
    plant("core/math.cl", "bits + 1u : bits - 1u", "bits + 2u : bits - 1u");
    EXPECT_EQ(selftest({"--only", "next_up"}).status, 3);
    expect_success(selftest({"--only", "exponential"}));
    expect_failure(render(), 1, {"next_up (kernels core/math.cl)"});
    // The device is at fault now and then.
    std::string verdicts = read_file(folder.path("cache/brandung/selftest.json"));
    options.environment.erase("KERNEL_DIR");
    expect_success(selftest({"--only", "next_up"}));
    expect_success(render());
}

TEST_F(SelfTest, AKernelThatDoesNotBuildHasFailed) {
    plant("core/math.cl", "FUNCTION float next_up", "FUNCTION flaot next_up");
    const Finished run = selftest({"--only", "next_up"});
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("does not build"), std::string::npos);
}

TEST_F(SelfTest, ABrokenFileOfVerdictsIsOneWarning) {
    fs::create_directories(folder.path("cache/brandung"));
    for (const char *text : {"{", "[1]", "[{\"key\": {}, \"subjects\": {\"sphere\": {\"passed\": 1, \"kernels\": \"\"}}}]", "3"}) {
        folder.write("cache/brandung/selftest.json", text);
        const Finished run = render();
        expect_success(run);
        EXPECT_TRUE(run.err.starts_with("warning: " + folder.path("cache/brandung/selftest.json") + ": not understood")) << run.err;
        EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    }
    const Finished run = selftest({"--only", "next_up"});
    expect_success(run);
    EXPECT_TRUE(run.err.starts_with("warning: ")) << run.err;
    EXPECT_EQ(selftest({"--only", "next_up"}).err, "");
}

TEST_F(SelfTest, AVerdictThatCannotBeRememberedIsAWarning) {
    options.environment["XDG_CACHE_HOME"] = "/proc/nowhere";
    options.environment["POCL_CACHE_DIR"] = folder.path("pocl");
    const Finished run = selftest({"--only", "next_up"});
    expect_success(run);
    EXPECT_TRUE(run.err.starts_with("warning: the verdict is not remembered: ")) << run.err;
}

TEST_F(SelfTest, WrongUsage) {
    expect_failure(selftest({"--only", "spheer"}), 2, {"there is no subject 'spheer'", "sphere, triangle"});
    expect_failure(selftest({"--long", "-1"}), 2, {"--long", "seconds"});
    expect_failure(selftest({"--device", "no such"}), 1, {"no suitable OpenCL device"});
}

}  // namespace
