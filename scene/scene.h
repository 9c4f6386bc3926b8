/// Scene: what a scene file says.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernels/core/params.h"
#include "kernels/core/scene.h"
#include "scene/accelerators/build_quality.h"
#include "scene/motion_parts.h"
#include "scene/primitives/shape.h"
#include "scene/textures/texture.h"
#include "scene/transform.h"
#include "scene/window.h"

namespace brandung {

/// Of cameras that have one.
struct LensDescription {
    float radius = 0;              ///< [world units]
    float focus_distance = 0;      ///< of the sharp plane along the view [world units]
    std::optional<vec3> focus_at;  ///< a point of that, instead
    uint blades = 0;               ///< of the aperture: the corners of a regular polygon; 0: it is round
    float blade_rotation = 0;      ///< angle of a corner from the right, counterclockwise as seen in the direction of view [degrees]
};

/// A view at a time.
struct CameraKey {
    double time;
    vec3 from, at, up;
};

struct CameraDescription {
    std::string name;
    vec3 from{0, 0, 1}, at{0, 0, 0}, up{0, 1, 0};  ///< of a camera that moves, those of the first key
    float fov = 0.78539816f;                       ///< full vertical angle [radians]
    std::vector<std::string> inside;               ///< names of the transparent materials that the eye is in
    uint kind = 0;                                 ///< its place in camera_kinds()
    // What only some kinds have.
    float height = 0;          ///< of the view [world units]
    float horizontal_fov = 0;  ///< full angle [radians]
    bool equisolid = false;    ///< distances from the picture's middle are as the sines of half the angles, instead of the angles
    LensDescription lens = {};
    Shutter shutter = {};
    std::vector<CameraKey> keys = {};  ///< empty if it is at rest while the shutter is open
};

struct FilmSettings {
    uint width = 512, height = 512;
    uint spp = 1;
    uint seed = 0;
    uint pixel = PIXEL_CENTER;
    uint sampler = 0;                 ///< its place in sampler_kinds()
    uint filter = 0;                  ///< its place in filter_kinds()
    float filter_radius = 0.5f;       ///< [pixels]
    bool splat = false;               ///< samples count in all pixels that the filter reaches, if it is not the pixel itself
    std::vector<uint> aovs;           ///< beside radiance: places in aov_kinds(), in order
    std::optional<Window> crop;       ///< the part to render, if not all
    float exposure = 0;               ///< of pictures of integers [EV]
    bool automatic_exposure = false;  ///< instead
    uint tone = 0;                    ///< curve of pictures of integers: its place in tone_kinds()

    Window window() const { return crop.value_or(Window{0, 0, width, height}); }

    bool operator==(const FilmSettings &) const = default;
};

struct IntegratorSettings {
    std::string type = "whitted";
    std::string type_place;         ///< `file:line: pointer` of what says the type, for errors; empty for the default
    uint max_depth = 5;             ///< rays in a chain, the eye ray being 1
    float threshold = 0;            ///< rays of smaller weight are not spawned
    uint light_samples = 1;         ///< of an emissive surface, the square root of how many of its points light another; 0: it lights nothing
    Bundles bundles{4, 4, 4, 4};    ///< of distributed rays
    uint roulette_depth = 4;        ///< from this surface of a path on, rays may end by chance
    bool follows_one = false;       ///< of a reflected and a refracted ray one is followed, chosen at random, instead of both
    bool filtered_shadows = false;  ///< transparent objects let light through, straight on
    bool shadows_unsaid = false;    ///< whether neither the scene's file, which could, nor an option says how shadows are

    /// Whether rays go on from every surface.
    bool traces_paths() const { return type == "path" || type == "distributed"; }
    Bundles bundles_in_use() const { return type == "distributed" ? bundles : Bundles{1, 1, 1, 1}; }
};

struct NamedMaterial {
    std::string name;
    Material record;
    std::string place = {};  ///< `file:line`, or `file`; empty: it is the scene file's own, by its number
};

/// Objects in a space of their own, which are seen where instances place them.
struct NamedGroup {
    std::string name;
    std::vector<std::unique_ptr<Shape>> shapes;
    Bounds bounds;  ///< of the shapes
};

/// A group placed in the world.
struct PlacedGroup {
    uint group;  ///< index into Scene::groups
    TransformPair transforms;
    Bounds bounds;                        ///< in the world, of the whole motion
    uint material = NO_MATERIAL;          ///< index into Scene::materials of what all its objects are made of, if not of their own
    uint object = NO_OBJECT;              ///< its number among the objects of the scene file
    std::vector<MotionPart> motion = {};  ///< while a shutter is open; empty: it is at rest. Else the transforms are those where that begins
};

struct Scene {
    std::string file;
    std::vector<std::string> files;          ///< all that have been read for it, itself first
    std::vector<CameraDescription> cameras;  ///< the first is the default
    Shutter shutter = {};                    ///< from when the first of the cameras opens until the last one has closed
    std::vector<NamedMaterial> materials;
    std::vector<Texture> textures;
    std::vector<std::unique_ptr<Shape>> shapes;
    std::vector<NamedGroup> groups;
    std::vector<PlacedGroup> instances;
    std::vector<Light> lights;
    std::optional<uint> headlight;  ///< the one of them, a point light, that stays where it is seen from the camera when that is turned
    Spectrum background{0}, ambient{0};
    uint background_texture = 0;  ///< number + 1 of the panorama that the background is multiplied by; 0: none
    float background_turn = 0;    ///< by which it is turned about the y axis [turns]
    FilmSettings film;
    IntegratorSettings integrator;
    std::string accelerator = "wide_bvh";  ///< or "auto", see runtime/accelerators/choose_accelerator.h
    BuildQuality accelerator_quality = BuildQuality::fast;
    std::map<std::string, uint> warnings;               ///< text -> how often
    std::map<std::string, std::string> warning_places;  ///< text -> where first, as "file:line", if that is known
    std::vector<std::string> notes;                     ///< what was chosen where the file says nothing, a line each
    std::optional<ShapePlaces> places;                  ///< only if who reads the scene asks for them
};

}  // namespace brandung
