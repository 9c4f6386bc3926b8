/// Scenes of the native format from text.
#pragma once
#include <gtest/gtest.h>

#include "scene/error.h"
#include "tests/scene/formats/temporary_file.h"

namespace brandung {

/// The error's text behind the file's name; empty if there is no error.
inline std::string error_of_text(const std::string &text, const std::vector<std::string> &assignments = {}) {
    const TemporaryFile file(text);
    try {
        read_scene(file.path, {assignments, {}, {}});
    } catch (const SceneError &error) {
        const std::string what = error.what();
        EXPECT_EQ(what.substr(0, file.path.size()), file.path);
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        return what.substr(file.path.size());
    }
    return {};
}

}  // namespace brandung
