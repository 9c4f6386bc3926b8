/// brandung render --trace.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

/// Events of one kind, in their order.
std::vector<json> events(const json &trace, const std::string &phase) {
    std::vector<json> found;
    for (const json &event : trace.at("traceEvents"))
        if (event.at("ph") == phase) found.push_back(event);
    return found;
}

struct Kernel {
    std::uint64_t launches = 0, items = 0;
    double milliseconds = 0;
};

}  // namespace

/// Its numbers are those of --stats: times are rounded to nanoseconds.
TEST(Trace, HasEveryLaunchBuildAndQueueOfTheRender) {
    const TemporaryFolder folder;
    const std::string stats_file = folder.path("stats.json"), trace_file = folder.path("trace.json");
    render_quietly({folder.write("scene.json", native_scene()), "--size", "64x48", "--spp", "4", "--batch", "4096", "-o", folder.path("out.exr"),
                    "--stats", stats_file, "--trace", trace_file});
    const json stats = json::parse(read_file(stats_file)), trace = json::parse(read_file(trace_file));

    std::map<std::string, Kernel> kernels;
    std::size_t builds = 0;
    double end = 0;
    for (const json &event : events(trace, "X")) {
        EXPECT_GE(event.at("ts").get<double>(), 0);
        EXPECT_GE(event.at("dur").get<double>(), 0);
        builds += event.at("tid") == 2;
        if (event.at("tid") != 3) continue;
        EXPECT_GE(event.at("ts").get<double>(), end - 0.01) << "launches are one after another";
        end = event.at("ts").get<double>() + event.at("dur").get<double>();
        Kernel &kernel = kernels[event.at("name")];
        ++kernel.launches, kernel.items += event.at("args").at("items").get<std::uint64_t>();
        kernel.milliseconds += event.at("dur").get<double>() / 1000;
    }
    EXPECT_GT(builds, 3u);
    EXPECT_EQ(kernels.size(), stats.at("kernels").size());
    for (const json &kernel : stats.at("kernels")) {
        const Kernel &traced = kernels[kernel.at("name")];
        EXPECT_EQ(traced.launches, kernel.at("launches")) << kernel;
        EXPECT_EQ(traced.items, kernel.at("items")) << kernel;
        EXPECT_NEAR(traced.milliseconds, kernel.at("milliseconds").get<double>(), 1e-6 * double(traced.launches)) << kernel;
    }

    std::uint64_t largest = 0;
    bool fast = false;
    for (const json &event : events(trace, "C")) {
        if (event.at("name") == "waiting rays" && event.at("args").contains("depth 1"))
            largest = std::max(largest, event.at("args").at("depth 1").get<std::uint64_t>());
        fast |= event.at("name") == "rays per second" && event.at("args").at("camera").get<double>() > 1000;
    }
    EXPECT_EQ(largest, 4096u) << "a whole batch waits at its beginning";
    EXPECT_TRUE(fast);
}

/// Killed when some of it has been written, by a signal that no program hears.
TEST(Trace, IsWrittenWhileTheRenderGoesOnAndIsJsonAtAnyTime) {
    const TemporaryFolder folder;
    const auto part = [&] {
        for (const std::string &name : folder.names())
            if (name.starts_with("trace.json.")) return folder.path(name);
        return std::string();
    };
    RunOptions options;
    options.signal_when = [&](const std::string &) {
        return !part().empty() && std::filesystem::file_size(part()) > 300'000 ? SIGKILL : 0;  // some pieces of 64 KiB
    };
    const Finished run = run_program({"render", folder.write("scene.json", native_scene()), "--size", "64x48", "--spp", "1000000", "--batch", "512",
                                      "-o", folder.path("out.exr"), "--trace", folder.path("trace.json")},
                                     options);
    EXPECT_EQ(run.signal, SIGKILL) << run.err;
    const json trace = json::parse(read_file(part()));
    EXPECT_GT(events(trace, "X").size(), 1000u);
    EXPECT_GT(events(trace, "C").size(), 100u);
}

TEST(Trace, IsRefusedWhereItCannotBeWritten) {
    const TemporaryFolder folder;
    const Finished run = render_native(folder, {"-o", folder.path("out.exr"), "--trace", folder.path("no/trace.json")});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("no/trace.json"), std::string::npos) << run.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.json"}) << "nothing was rendered";
}
