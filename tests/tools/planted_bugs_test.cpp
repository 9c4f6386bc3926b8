/// tools/planted_bugs: what it does without planting any.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

namespace {

int status_of(const std::string &arguments) {
    return WEXITSTATUS(std::system((BRANDUNG_SOURCE_DIR "/tools/planted_bugs " + arguments + " >/dev/null 2>&1").c_str()));
}

TEST(PlantedBugs, TextsThatBugsReplaceAreThere) { EXPECT_EQ(status_of("--check"), 0) << "see tools/planted_bugs --check"; }

TEST(PlantedBugs, HelpIsNoRunAndWrongWordsAreWrongUsage) {
    EXPECT_EQ(status_of("--help"), 0);
    EXPECT_EQ(status_of("--check kernels/ scene/"), 0);
    EXPECT_EQ(status_of("--check scene/ no_such_file"), 2);
    EXPECT_EQ(status_of("--no-such-option"), 2);
}

}  // namespace
