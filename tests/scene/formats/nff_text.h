/// NFF texts as files, and what is wrong with them.
#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/error.h"
#include "scene/formats/format.h"

namespace brandung {

/// A file that is there while the value lives.
class NffFile {
public:
    explicit NffFile(const std::string &text) : path_(std::filesystem::temp_directory_path() / fmt::format("brandung_nff_test_{}.nff", getpid())) {
        std::ofstream(path_, std::ios::binary) << text;
    }
    ~NffFile() { std::filesystem::remove(path_); }
    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

inline Scene read_nff_text(const std::string &text, const std::vector<std::string> &assignments = {}) {
    const NffFile file(text);
    return read_scene(file.path(), {assignments, {}, {}});
}

/// The message about a bad text, without the file's name; empty if nothing is wrong with it.
inline std::string error_of_nff_text(const std::string &text, const std::vector<std::string> &assignments = {}) {
    const NffFile file(text);
    try {
        read_scene(file.path(), {assignments, {}, {}});
    } catch (const SceneError &error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos);
        EXPECT_EQ(message.rfind(file.path() + ":", 0), 0u) << message;
        return message.substr(std::min(message.size(), file.path().size() + 1));
    }
    return "";
}

/// Lines 1 to 7 of a text.
inline const std::string nff_viewpoint = "v\nfrom 1 2 3\nat 0 0 0\nup 0 0 1\nangle 60\nhither 0.1\nresolution 320 200\n";

/// Every entity, with blanks and comments in odd places.
inline const std::string good_nff = R"(# a comment
b 0.1 0.2 0.3
v # and another
from 1 2 3
at 4 5 6
up 0 0 1
angle 90
hither 0.1
resolution 320 200
l 1 2 3
l 4 5 6 1 0.5 0.25
f 1 0.5 0.25 0.5 0 10 0 0
p 4
0 0 0
1 0 0
1 1 0
0 1 0
p 3 0 0 1  1 0 1  0 1 1
pp 3
0 0 2 0 0 2
1 0 2 0 3 4
0 1 2 1 0 0
f 1 1 1 0.1 0.2 +3e1 0.9 1.5
s 1 2 3 0.5
c
0 0 0 2
0 0 4 1
s 1 2 3 -0.5
f 1 1 1 0.1 0.2 30 0 1.5
c 0 0 0 -2 0 0 4 -1
)";

}  // namespace brandung
