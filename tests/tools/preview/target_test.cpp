#include "tools/preview/target.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace brandung {
namespace {

std::string read(const std::string &text) {
    const PreviewTarget target = read_preview_target(text);
    return (target.kind == PreviewTarget::tev ? "tev " : "web ") + target.host + " " + std::to_string(target.port);
}

TEST(PreviewTargets, AreReadWithTheirDefaults) {
    EXPECT_EQ(read("tev"), "tev 127.0.0.1 14158");
    EXPECT_EQ(read("tev:viewer.example:99"), "tev viewer.example 99");
    EXPECT_EQ(read("tev:[::1]:99"), "tev ::1 99");
    EXPECT_EQ(read("web"), "web 127.0.0.1 8080");
    EXPECT_EQ(read("web:0"), "web 127.0.0.1 0");
    EXPECT_EQ(read("web:65535"), "web 127.0.0.1 65535");
}

TEST(PreviewTargets, OthersAreWrongUsage) {
    for (const char *text : {"", "tv", "tev:", "tev:99", "tev::99", "tev:host", "tev:host:", "tev:host:0", "tev:host:65536", "tev:host:9x",
                             "web:", "web:-1", "web:65536", "web:80x", "web:host:80", "web8080", "TEV"})
        EXPECT_THROW(read_preview_target(text), CLI::ValidationError) << text;
}

}  // namespace
}  // namespace brandung
