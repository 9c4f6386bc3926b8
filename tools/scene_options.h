/// What render and info are told in the same way: a scene, changes to its settings, and on what it is rendered.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "runtime/wavefront/batch.h"
#include "scene/formats/format.h"

namespace CLI {
class App;
}

namespace brandung {

struct SceneOptions {
    std::string scene, integrator, accelerator, accelerator_quality, follow, shadows, size, crop, pixel, sampler, filter, exposure, tone, camera,
        background, device;
    std::vector<std::string> aovs;
    std::vector<std::string> bundles;   ///< "KIND=SIZE"
    std::string from, at, up;           ///< "X,Y,Z", or empty for the camera's own
    std::optional<float> fov;           ///< [degrees]
    std::vector<std::string> settings;  ///< "KEY=VALUE"
    std::vector<std::string> varied;    ///< the same, which count where other options say something else; no option
    std::optional<uint> spp, seed, max_depth, light_samples;
    uint batch = default_batch, threads = 0;
    bool untrusted_device = false;  ///< take one that is known to have failed the self-test
    bool keep_places = false;       ///< of shapes in their files; no option
};

/// What a scene is and how it looks. `options` must live until the command has run.
void add_scene_options(CLI::App &command, SceneOptions &options);
/// The same but for the scene's file and its accelerator.
void add_scene_settings(CLI::App &command, SceneOptions &options);
/// On what it is rendered.
void add_device_options(CLI::App &command, SceneOptions &options);
/// The scene with its settings and cameras changed. Throws SceneError, and CLI::ValidationError for a size that is none, or a vector.
Scene read_scene(const SceneOptions &options, const ReadProgress &progress = {});
/// The scene's camera of that name, its first if the name is empty. Throws SceneError if there is none.
const CameraDescription &chosen_camera(const Scene &scene, const std::string &name);

}  // namespace brandung
