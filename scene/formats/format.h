/// Readers of scene files.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brandung {

struct SceneFormat {
    const char *extension;  ///< ".nff"
    /// `assignments` are "KEY=VALUE" changes to the settings, made before they are interpreted.
    Scene (*read)(const std::string &file, const std::vector<std::string> &assignments);
};
const std::vector<SceneFormat> &scene_formats();

/// Reads a scene by its extension. Throws SceneError with file, line and cause.
Scene read_scene(const std::string &file, const std::vector<std::string> &assignments = {});

class Parameters;
/// The sections "film" and "integrator" and the values "accelerator" and "background" of a document, over what `scene` has.
void read_settings(const Parameters &root, Scene &scene);

}  // namespace brandung
