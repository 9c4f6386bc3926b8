/// The list of scene formats.
#include "scene/formats/format.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "scene/cameras/camera.h"
#include "scene/error.h"
#include "scene/input.h"
#include "scene/nothing_to_see.h"

namespace brandung {

Scene read_native(const std::string &file, const ReadOptions &options);
Scene read_nff(const std::string &file, const ReadOptions &options);
Scene read_obj_scene(const std::string &file, const ReadOptions &options);
Scene read_ply_scene(const std::string &file, const ReadOptions &options);

namespace {

void change_view(const ViewChanges &changes, Scene &scene) {
    for (CameraDescription &camera : scene.cameras) {
        const CameraKind &kind = camera_kinds()[camera.kind];
        if (changes.fov && kind.fov.usual == 0)
            throw SceneError(scene.file + ": camera \"" + camera.name + "\" is " + kind.name + " and has no \"fov\"");
        changes.apply(camera);
        if (const auto fault = view_fault(camera))
            throw SceneError(scene.file + ": camera \"" + camera.name + "\", as changed: \"" + fault->key + "\" " + fault->why);
    }
}

}  // namespace

const std::vector<SceneFormat> &scene_formats() {
    static const std::vector<SceneFormat> formats = {
        {".json", read_native},
        {".nff", read_nff},
        {".obj", read_obj_scene},
        {".ply", read_ply_scene},
    };
    return formats;
}

Scene read_scene(const std::string &file, const ReadOptions &options) {
    check_readable(file);
    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    std::string known;
    for (const SceneFormat &format : scene_formats()) {
        if (extension == format.extension) {
            Scene scene = format.read(file, options);
            scene.files.insert(scene.files.begin(), file);
            change_view(options.view, scene);
            warn_of_nothing_to_see(scene);
            return scene;
        }
        known += std::string(" ") + format.extension;
    }
    throw SceneError(file + ": unknown scene format \"" + extension + "\"; known by extension:" + known);
}

}  // namespace brandung
