/// Readers of scene files.
#pragma once
#include <string>
#include <vector>

#include "scene/input.h"
#include "scene/scene.h"
#include "scene/view.h"

namespace brandung {

struct ReadOptions {
    std::vector<std::string> assignments;  ///< "KEY=VALUE" changes to the settings, made before they are interpreted
    ViewChanges view;                      ///< of all cameras, or of the one that the scene gets where its file has none
    ReadProgress progress;                 ///< may be empty
    bool keep_places = false;              ///< whether the scene has them
};

struct SceneFormat {
    const char *extension;  ///< ".nff"
    Scene (*read)(const std::string &file, const ReadOptions &options);
};
const std::vector<SceneFormat> &scene_formats();

/// Reads a scene by its extension. Throws SceneError with file, line and cause.
Scene read_scene(const std::string &file, const ReadOptions &options = {});

class Parameters;
/// The sections "film" and "integrator" and the values "accelerator", "accelerator_quality" and "background" of a document, over what `scene` has.
void read_settings(const Parameters &root, Scene &scene);
/// The same of assignments alone, for formats whose files have no settings. Refuses others.
void assign_settings(const std::vector<std::string> &assignments, Scene &scene);

}  // namespace brandung
