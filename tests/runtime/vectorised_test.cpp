/// Stages are vectorised: the property is lost silently (a library call, a switch, a vector type), and costs up to four times the time.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "scene/bsdfs/bsdf.h"
#include "scene/cameras/camera.h"
#include "scene/compile.h"
#include "scene/formats/format.h"
#include "scene/lights/light.h"

namespace {

namespace fs = std::filesystem;

/// A folder of its own that goes when the test does.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / ("brandung_vectorised_" + std::to_string(getpid()))) { fs::create_directories(path_); }
    ~Folder() { fs::remove_all(path_); }
    const fs::path &path() const { return path_; }

private:
    fs::path path_;
};

std::string read_text(const fs::path &path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// All kinds of primitives and lights; the material decides which kernels are built. `more`: further objects.
std::string scene_of(const std::string &material, const std::string &filter = "box", const std::string &more = "", const std::string &follow = "both",
                     const std::string &integrator = "whitted", const std::string &materials = "") {
    return R"({"film": {"width": 32, "height": 32, "spp": 4, "aovs": ["all"], "filter": ")" + filter +
           R"("}, "camera": {"from": [0, 1, 6], "at": [0, 0, 0], "fov": 40}, "ambient": 0.1,
        "background": {"image": ")" BRANDUNG_SOURCE_DIR R"(/scene/examples/sun.hdr"},
        "integrator": {"type": ")" +
           integrator + R"(", "shadows": "filtered", "follow": ")" + follow + R"("},
        "materials": [{"name": "m", "type": "whitted", "diffuse": 0.5, "specular": 0.4, "exponent": 20)" +
           material + R"(}, {"name": "lamp", "type": "whitted", "emission": 1})" + materials + R"(],
        "lights": [{"type": "point", "position": [3, 5, 4], "intensity": 100}, {"type": "directional", "direction": [0, -1, -1], "irradiance": 1},
            {"type": "spot", "position": [-3, 5, 4], "at": [0, 0, 0], "intensity": 100, "angle": 40}],
        "objects": [{"type": "sphere", "material": "m", "center": [0, 0, 0], "radius": 1},
            {"type": "sphere", "material": "lamp", "center": [0, 3, 0], "radius": 0.5},
            {"type": "cylinder", "material": "lamp", "base": [-2, 3, 0], "apex": [-2, 4, 0], "radius": 0.5},
            {"type": "disk", "material": "lamp", "center": [3, 3, 0], "normal": [0, -1, 0], "radius": 0.5},
            {"type": "disk", "material": "m", "center": [3, 0, 0], "normal": [0, 1, 0], "radius": 0.5},
            {"type": "polygon", "material": "lamp", "vertices": [[1, 3, 0], [2, 3, 0], [2, 3, 1], [1, 3, 2]]},
            {"type": "cylinder", "material": "m", "base": [-2, -1, 0], "apex": [-2, 1, 0], "radius": 0.5},
            {"type": "polygon", "material": "m", "vertices": [[-4, -1, 4], [4, -1, 4], [4, -1, -4], [-4, -1, -4]]},
            {"type": "triangle_mesh", "material": "m", "positions": [[1, -1, 0], [3, -1, 0], [2, 1, 0]], "normals": [[0, 0, 1], [0.1, 0, 1], [0, 0.1, 1]],
             "indices": [0, 1, 2]})" +
           more + R"(], "groups": [{"name": "g", "objects": [{"type": "sphere", "material": "m", "center": [0, 0, 0], "radius": 1}]}]})";
}

/// What the vectoriser says while the program renders: text without line ends, "kernels/<file>:<line>:<column>: <remark>" again and again.
/// -g in PoCL's build flags makes it name lines, the folder's own cache makes it compile what no scene before needed there.
std::string remarks_of(const std::string &scene, const Folder &folder = Folder()) {
    std::ofstream(folder.path() / "scene.json") << scene;
    const std::string command = "cd '" + folder.path().string() + "' && mkdir -p cache && POCL_CACHE_DIR=$PWD/cache POCL_VECTORIZER_REMARKS=1 " +
                                "POCL_EXTRA_BUILD_FLAGS=-g KERNEL_DIR='" BRANDUNG_SOURCE_DIR "/kernels' '" BRANDUNG_PROGRAM
                                "' render scene.json -o picture.exr --quiet >remarks 2>errors";
    const int status = std::system(command.c_str());
    EXPECT_EQ(status, 0) << read_text(folder.path() / "errors");
    return read_text(folder.path() / "remarks");
}

/// A loop by "file:line".
struct Remarks {
    std::set<std::string> vectorised;           ///< at width 16, or before the remarks begin
    std::map<std::string, std::string> failed;  ///< and why
};

/// Loops whose bodies call no built-in function are vectorised already when the program is built, where PoCL gives no remarks; later it says that
/// they have been. A loop with the mark that could not be vectorised is always named with another reason.
Remarks parse(const std::string &text) {
    static const std::regex remark(
        R"((kernels/[a-z0-9_/]+\.cl:\d+):\d+: (vectorized loop \(vectorization width: \d+|loop not vectorized[^<]*?(?=kernels/|<|$)))");
    Remarks remarks;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), remark); match != std::sregex_iterator(); ++match) {
        const std::string loop = (*match)[1], what = (*match)[2];
        if (what == "vectorized loop (vectorization width: 16" || what.find("already been vectorized") != std::string::npos)
            remarks.vectorised.insert(loop);
        else
            remarks.failed.emplace(loop, what);
    }
    return remarks;
}

/// Every use of FOR_EACH_ITEM under kernels/ that scenes of an integrator may need, which is the promise of a vectorised loop, by "file:line".
std::set<std::string> marked_loops(const std::string &integrator = "whitted") {
    std::set<std::string> loops;
    for (const auto &file : fs::recursive_directory_iterator(BRANDUNG_SOURCE_DIR "/kernels")) {
        const fs::path folder = file.path().parent_path().filename();
        if (folder == "integrators" && file.path().stem() != integrator) continue;
        if (file.path().extension() != ".cl" || folder == "selftest" || folder == "bench") continue;  // renders have none of these
        std::istringstream lines(read_text(file.path()));
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number)
            if (line.find(" FOR_EACH_ITEM(") != std::string::npos && line.find("#define") == std::string::npos)
                loops.insert(fs::relative(file.path(), BRANDUNG_SOURCE_DIR).string() + ":" + std::to_string(number));
    }
    return loops;
}

void expect_no_failure(const Remarks &remarks, const std::set<std::string> &loops = marked_loops()) {
    for (const std::string &loop : loops)
        if (const auto failed = remarks.failed.find(loop); failed != remarks.failed.end()) ADD_FAILURE() << loop << ": " << failed->second;
}

/// With those of a render whose samples are splatted, which others are not.
Remarks with_splats(Remarks remarks) {
    static const Remarks of_splats = parse(remarks_of(scene_of("", R"(tent", "splat": true, "pixel": "center)")));
    remarks.vectorised.insert(of_splats.vectorised.begin(), of_splats.vectorised.end());
    remarks.failed.insert(of_splats.failed.begin(), of_splats.failed.end());
    return remarks;
}

}  // namespace

TEST(Vectorised, EveryMarkedLoopIs16WideInASceneWithEverything) {
    Remarks remarks = parse(remarks_of(scene_of(R"(, "reflection": 0.3, "transmission": 0.5, "eta": 1.5, "fresnel": true)", "mitchell",
                                                R"(, {"type": "instance", "group": "g", "transform": {"translate": [0, 2, 0]}},
            {"type": "triangle_mesh", "material": "m", "positions": [[1, 1, 0], [3, 1, 0], [2, 2, 0]], "colors": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
             "indices": [0, 1, 2]}, {"type": "sphere", "material": "mix", "center": [3, 0, 0], "radius": 1})",
                                                "both", "whitted",
                                                R"(, {"name": "bright", "type": "whitted"},
            {"name": "mix", "type": "mix", "first": "bright", "second": "sided"}, {"name": "sided", "type": "two_sided", "front": "shiny", "back": "bright"},
            {"name": "shiny", "type": "whitted", "reflection": 0.5})")));
    remarks = with_splats(std::move(remarks));
    expect_no_failure(remarks);
    const std::set<std::string> loops = marked_loops();
    EXPECT_GE(loops.size(), 8u);
    for (const std::string &loop : loops) EXPECT_TRUE(remarks.vectorised.contains(loop)) << loop;
}

TEST(Vectorised, EveryMarkedLoopIs16WideWhereOneOfTwoRaysIsFollowed) {
    const Remarks remarks = with_splats(parse(remarks_of(scene_of(R"(, "reflection": 0.3, "transmission": 0.5, "eta": 1.5)", "box", "", "one"))));
    expect_no_failure(remarks);
    for (const std::string &loop : marked_loops()) EXPECT_TRUE(remarks.vectorised.contains(loop)) << loop;
}

/// Materials of all kinds, on which rays of each must not depend: every one is evaluated, and one selected.
TEST(Vectorised, PathsAre16WideWithEveryKindOfMaterial) {
    std::string materials, objects;
    for (const brandung::BsdfKind &kind : brandung::bsdf_kinds()) {
        const std::string type = kind.name, metal = type == "conductor" ? R"(, "metal": "gold")" : "";
        const std::string rough = type == "conductor" || type == "dielectric" ? R"(, "roughness": 0.3)" : "";
        materials += R"(, {"name": "of )" + type + R"(", "type": ")" + type + R"(")" + metal + rough + "}";
        objects += R"(, {"type": "sphere", "material": "of )" + type + R"(", "center": [0, 2, 0], "radius": 0.1})";
    }
    for (const std::string integrator : {"path", "distributed"}) {
        const std::string scene = scene_of(R"(, "reflection": 0.3, "transmission": 0.5, "eta": 1.5)", "box", objects, "both", integrator, materials);
        const Remarks remarks = parse(remarks_of(scene));
        std::set<std::string> loops = marked_loops("path");
        if (integrator == "distributed") loops.merge(marked_loops("bundle"));
        expect_no_failure(remarks, loops);
        for (const std::string &loop : loops)
            EXPECT_TRUE(remarks.vectorised.contains(loop) || loop.find("/integrators/") == std::string::npos) << integrator << ", " << loop;
    }
}

TEST(Vectorised, CamerasOfEveryKindAre16Wide) {
    const Folder folder;
    for (const brandung::CameraKind &kind : brandung::camera_kinds()) {
        const Remarks remarks =
            parse(remarks_of(R"({"film": {"width": 32, "height": 32, "spp": 4}, "background": 1, "camera": {"type": ")" + std::string(kind.name) +
                                 R"(", "from": [0, 1, 6], "at": [0, 0, 0])" + (kind.name == std::string("orthographic") ? R"(, "height": 2)" : "") +
                                 (kind.name == std::string("thin_lens") ? R"(, "lens_radius": 1, "focus_distance": 6)" : "") + "}}",
                             folder));
        std::size_t loops = 0;
        for (const std::string &loop : marked_loops()) {
            if (loop.find("generate_camera_rays.cl") == std::string::npos) continue;
            EXPECT_TRUE(remarks.vectorised.contains(loop)) << kind.name;
            ++loops;
        }
        EXPECT_EQ(loops, 1u);
    }
}

TEST(Vectorised, TheSceneHasEveryKindOfPrimitiveAndLight) {
    const Folder folder;
    const fs::path file = folder.path() / "scene.json";
    std::set<uint> lights;
    for (const std::string integrator : {"whitted", "path"}) {
        std::ofstream(file) << scene_of("", "box", "", "both", integrator);
        const brandung::CompiledScene scene = brandung::compile(brandung::read_scene(file.string()));
        EXPECT_EQ(scene.primitives.size(), brandung::primitive_kinds().size());
        lights.insert(scene.lights.begin(), scene.lights.end());
    }
    EXPECT_EQ(lights.size(), brandung::light_kinds().size());
}

TEST(Vectorised, ParseTellsVectorisedLoopsFromOthers) {
    const Remarks remarks = parse(
        "<unknown>:0:0: hoisting addkernels/stages/a.cl:8:5: vectorized loop (vectorization width: 16, interleaved count: 1)kernels/stages/b.cl:9:5: "
        "vectorized loop (vectorization width: 8, interleaved count: 1)kernels/stages/c.cl:7:9: loop not vectorized: instruction return type cannot "
        "be "
        "vectorized<unknown>:0:0: 12 instructions in functionkernels/stages/d.cl:3:1: loop not vectorized: vectorization and interleaving are "
        "explicitly "
        "disabled, or the loop has already been vectorized");
    EXPECT_EQ(remarks.vectorised, (std::set<std::string>{"kernels/stages/a.cl:8", "kernels/stages/d.cl:3"}));
    EXPECT_EQ(remarks.failed.size(), 2u);
    EXPECT_TRUE(remarks.failed.contains("kernels/stages/b.cl:9"));
    EXPECT_TRUE(remarks.failed.contains("kernels/stages/c.cl:7"));
}
