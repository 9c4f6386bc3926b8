#include "tests/support/random_scenes/trial.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "scene/accelerators/accelerator.h"
#include "scene/formats/format.h"
#include "tests/support/random_scenes/random_scene.h"
#include "tests/support/rendering.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

/// Removed at the end of the process.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / fmt::format("random_scenes.{}", getpid())) {
        fs::create_directory(path_);
        for (const char *file : {"tiles.png", "sky.png", "vase.obj", "vase.mtl"})
            fs::create_symlink(fs::path(BRANDUNG_SOURCE_DIR) / "scene" / "examples" / file, path_ / file);
    }
    ~Folder() { fs::remove_all(path_); }
    const fs::path &path() const { return path_; }

private:
    fs::path path_;
};

std::string described(const Rendering &rendering) {
    std::string text = fmt::format("film {:016x}", film_hash(rendering.film));
    for (uint kind = 0; kind < RAY_KINDS; ++kind)
        text += fmt::format(", {} rays of kind {} with {} hits", rendering.counts.rays[kind], kind, rendering.counts.hits[kind]);
    return text + fmt::format(", {} media lost", rendering.media_lost);
}

}  // namespace

Scene read_random_scene(std::uint64_t seed, double scale) {
    static const Folder folder;
    const fs::path file = folder.path() / "scene.json";
    std::ofstream(file) << random_scene(seed, scale).dump(1);
    return read_scene(file);
}

std::vector<std::string> faults_of(Scene &scene, bool specialised, Scene *scaled) {
    std::vector<std::string> faults;
    std::string expected;
    const auto expect_the_same = [&](const std::string &how, const Scene &scene, const RenderOptions &options, Kinds kinds) {
        const Rendering rendering = render_scene(scene, options, kinds);
        const std::string what = described(rendering);
        if (rendering.refused > 0) faults.push_back(fmt::format("{}: {} contributions are not finite", how, rendering.refused));
        if (!expected.empty() && what != expected) faults.push_back(fmt::format("{}: {}, but {} before", how, what, expected));
        expected = what;
    };
    uint batch = 1000;
    for (const AcceleratorKind &accelerator : accelerator_kinds()) {
        scene.accelerator = accelerator.name;
        expect_the_same(fmt::format("{}, batch {}", accelerator.name, batch), scene, {.batch = batch}, Kinds::all);
        batch = 97;
    }
    scene.accelerator = accelerator_kinds().front().name, scene.accelerator_quality = BuildQuality::high;
    expect_the_same("quality high", scene, {.batch = 1000}, Kinds::all);
    if (scaled) expect_the_same("scaled", *scaled, {.batch = 1000}, Kinds::all);
    if (specialised) expect_the_same(fmt::format("{}, kernels of the scene", scene.accelerator), scene, {.batch = 1000}, Kinds::in_use);
    return faults;
}

bool is_scalable(const Scene &scene) {
    return std::none_of(scene.files.begin(), scene.files.end(), [](const std::string &file) { return file.ends_with(".obj"); });
}

}  // namespace brandung
