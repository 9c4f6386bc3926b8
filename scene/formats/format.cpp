/// The list of scene formats.
#include "scene/formats/format.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "scene/error.h"
#include "scene/input.h"

namespace brandung {

Scene read_native(const std::string &file, const std::vector<std::string> &assignments);
Scene read_nff(const std::string &file, const std::vector<std::string> &assignments);

const std::vector<SceneFormat> &scene_formats() {
    static const std::vector<SceneFormat> formats = {
        {".json", read_native},
        {".nff", read_nff},
    };
    return formats;
}

Scene read_scene(const std::string &file, const std::vector<std::string> &assignments) {
    check_readable(file);
    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    std::string known;
    for (const SceneFormat &format : scene_formats()) {
        if (extension == format.extension) return format.read(file, assignments);
        known += std::string(" ") + format.extension;
    }
    throw SceneError(file + ": unknown scene format \"" + extension + "\"; known by extension:" + known);
}

}  // namespace brandung
