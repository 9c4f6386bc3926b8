#include "tests/tools/runs.h"

#include <gtest/gtest.h>

#include "tests/tools/scenes.h"

void expect_success(const Finished &run) {
    EXPECT_EQ(run.status, 0) << "signal " << run.signal << (run.timed_out ? ", timed out\n" : "\n") << run.err;
}

void render_quietly(const std::vector<std::string> &arguments) {
    std::vector<std::string> all = {"render", "--quiet"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Finished run = run_program(all);
    expect_success(run);
    EXPECT_EQ(run.err, "");
}

Finished render_native(const TemporaryFolder &folder, const std::vector<std::string> &arguments) {
    std::vector<std::string> all = {"render", folder.write("scene.json", native_scene())};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program(all);
}
