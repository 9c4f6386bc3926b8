#include "tests/tools/bad_input.h"

#include <gtest/gtest.h>

#include <algorithm>

void expect_failure(const Finished &run, int status, const std::vector<std::string> &parts) {
    ASSERT_FALSE(run.timed_out) << "hangs; so far it wrote\n" << run.out << run.err;
    ASSERT_EQ(run.signal, 0) << "crashes\n" << run.err;
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(run.out, "");
    std::vector<std::string> errors;
    for (const std::string &line : lines_of(run.err))
        if (!line.starts_with("warning: ")) errors.push_back(line);
    ASSERT_EQ(errors.size(), 1u) << "one line, not\n" << run.err;
    EXPECT_TRUE(errors[0].starts_with("brandung: ")) << errors[0];
    EXPECT_TRUE(run.err.ends_with("\n"));
    for (const std::string &part : parts) EXPECT_NE(errors[0].find(part), std::string::npos) << "expected '" << part << "' in\n" << errors[0];
    for (const char c : errors[0]) EXPECT_TRUE(static_cast<unsigned char>(c) >= ' ' && c != '\x7f') << "control character in the message";
}

void expect_render_fails(const TemporaryFolder &folder, const std::string &scene, const std::vector<std::string> &more, int status,
                         const std::vector<std::string> &parts, const RunOptions &options) {
    const std::vector<std::string> before = folder.names();
    std::vector<std::string> arguments = {"render", scene, "--quiet"};
    if (std::find(more.begin(), more.end(), "-o") == more.end()) arguments.insert(arguments.end(), {"-o", folder.path("out.png")});
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_failure(run_program(arguments, options), status, parts);
    EXPECT_EQ(folder.names(), before) << "nothing is left behind";
}
