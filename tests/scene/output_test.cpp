#include "scene/output.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "scene/error.h"
#include "scene/input.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

class Output : public testing::Test {
protected:
    Output() { fs::create_directory(folder); }
    ~Output() override { fs::remove_all(folder); }

    std::string file(const std::string &name) const { return (folder / name).string(); }
    /// The message of what `action` throws, which must be a SceneError.
    template <class Action> static std::string error_of(Action action) {
        try {
            action();
        } catch (const SceneError &error) {
            return error.what();
        }
        return "";
    }

    const fs::path folder = fs::temp_directory_path() / ("brandung-output-" + std::to_string(getpid()));
};

TEST_F(Output, NamesAsLongAsTheFileSystemTakesThemAreWritten) {
    const std::string longest = file(std::string(251, 'x') + ".txt");
    check_writable(longest);
    write_text(longest, "text");
    EXPECT_EQ(file_text(longest), "text");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(Output, LongerNamesAreRefusedInTheUsualForm) {
    const std::string longer = file(std::string(300, 'x') + ".txt");
    EXPECT_EQ(error_of([&] { check_writable(longer); }), longer + ": cannot write there: File name too long");
    EXPECT_EQ(error_of([&] { write_text(longer, "text"); }), longer + ": cannot write there: File name too long");
    EXPECT_EQ(error_of([&] { check_readable(longer); }), longer + ": cannot be read: File name too long");
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Output, WhatCannotBeRenamedIsReportedAndRemoved) {
    fs::create_directories(file("taken/inside"));
    EXPECT_TRUE(error_of([&] { write_text(file("taken"), "text"); }).starts_with(file("taken") + ": cannot write there: "));
    EXPECT_EQ(error_of([&] { check_writable(file("taken")); }), file("taken") + ": cannot write there: it is a folder");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

/// 20 000 lines of 10 bytes are more than are kept until they are written.
TEST_F(Output, AGrowingTextIsCompleteInFormAllTheTime) {
    const auto only_file = [&] { return file_text(fs::directory_iterator(folder)->path().string()); };
    {
        GrowingText text(file("text"), "end\n");
        for (int line = 0; line < 20'000; ++line) text.append("123456789\n");
        const std::string part = only_file();
        EXPECT_GT(part.size(), 100'000u);
        EXPECT_LT(part.size(), 200'000u);
        EXPECT_TRUE(part.ends_with("123456789\nend\n"));
        EXPECT_FALSE(fs::exists(file("text"))) << "it is not complete";
        text.finish();
    }
    EXPECT_EQ(file_text(file("text")).size(), 200'004u);
    { GrowingText(file("other"), "end\n").append("123456789\n"); }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "what was not finished is removed";
    EXPECT_EQ(error_of([&] { GrowingText(file("no/text"), ""); }), file("no/text") + ": cannot write there: No such file or directory");
}

/// Over two links, the last of which leads to a file that is not there yet, from another folder.
TEST_F(Output, LinksAreWrittenThrough) {
    fs::create_directory(file("there"));
    fs::create_symlink("there/b.txt", file("a.txt"));
    fs::create_symlink("c.dat", file("there/b.txt"));
    check_writable(file("a.txt"));
    for (const char *text : {"first", "second"}) {
        write_text(file("a.txt"), text);
        EXPECT_EQ(file_text(file("there/c.dat")), text);
    }
    EXPECT_TRUE(fs::is_symlink(file("a.txt")) && fs::is_symlink(file("there/b.txt")));
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder), {}), 4);
    EXPECT_EQ(linked_file(file("a.txt")), file("there/c.dat"));
    fs::create_symlink("circle", file("circle"));
    EXPECT_NE(error_of([&] { check_writable(file("circle")); }), "");
}

TEST_F(Output, TryingLeavesNothing) {
    std::string written;
    try_writing(file("a.txt"), [&](const std::string &name) { write_text(written = name, "text"); });
    EXPECT_TRUE(written.ends_with(".txt")) << "formats go by extension";
    EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace brandung
