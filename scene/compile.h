/// From a Scene to the arena that kernels read.
#pragma once
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "kernels/core/scene.h"
#include "scene/scene.h"

namespace brandung {

struct AcceleratorKind;

/// So many media a ray can be in at once; what it enters beyond them is left out.
inline constexpr uint max_interior_size = 8;

/// Which kinds of things kernels are made for: those of the scene, or all, so that one set of kernels renders every scene. The picture is the same.
enum class Kinds { in_use, all };

/// The scene's records, laid out, and which kinds of things they are.
struct CompiledScene {
    SceneHeader header{};
    std::vector<std::byte> arena;
    std::vector<Texel> texels;                      ///< of textures in use
    std::vector<const PrimitiveKind *> primitives;  ///< kinds in use; a kind's place is its number on the device
    std::vector<uint> bsdfs, lights;                ///< kinds in use: places in bsdf_kinds() and light_kinds(), which are their numbers
    uint filter = 0, sampler = 0;                   ///< in use: their places in filter_kinds() and sampler_kinds()
    const AcceleratorKind *accelerator = nullptr;
    bool reflects = false, transmits = false;  ///< whether any material spawns such rays
    bool instances = false;                    ///< whether rays look into groups
    bool moves = false;                        ///< whether any instance moves while the shutter is open
    bool paths = false;                        ///< whether rays go on from every surface
    bool bundles = false;                      ///< whether they go on from the first surface as several, or ask for light there several times
    bool follows_one = false;                  ///< whether of a reflected and a refracted ray one is chosen
    bool filters_shadows = false;              ///< whether transparent objects let light through, and there are some
    bool emissive_instances = false;           ///< whether any light is an emissive shape of an instance
    bool environment = false;                  ///< whether the background is a light
    uint facets = 0;                           ///< a bit for each distribution that rough surfaces have
    bool losses = false;                       ///< whether rough dielectrics have tables of what their facets take from each other
    bool highlights = false;                   ///< whether any material has one
    bool ideal = false;                        ///< whether any mirrors light, or lets it pass, in single directions
    bool shading_normals = false;              ///< whether any primitive has normals of its own for shading
    bool chooses = false;                      ///< whether any material stands for others, of which one counts at every hit
    bool tints = false;                        ///< whether pictures or vertices give any hit or miss a colour
    uint bundle = 1;                           ///< rays that go on from the first surface, at most
    uint interior_size = 0;                    ///< entries of a ray's list of media: at least the number of `media` up to max_interior_size
    uint media = 0;                            ///< transparent materials of things, and those that an eye is in, if there are things to refract
    std::size_t primitive_count = 0;           ///< those of a group count once
    bool blocks_at_root = false;               ///< of the world, as BuiltAccelerator has it
    std::size_t texture_count = 0;             ///< pictures on surfaces
    std::size_t group_count = 0, instance_count = 0;
    std::vector<std::size_t> counts;                    ///< of primitives, by kind in use
    uint dark_emitters = 0;                             ///< emissive shapes that would be lights, but for integrator.light_samples
    std::map<std::string, uint> light_counts;           ///< of lights and emissive shapes, by kind
    double accelerator_seconds = 0;                     ///< from the shapes to nodes and blocks in the arena
    std::size_t node_bytes = 0;                         ///< of accelerators
    std::size_t block_bytes = 0;                        ///< of the primitives and instances in their blocks
    std::size_t shading_bytes = 0;                      ///< of shading records, and of vertices' normals, coordinates and colours
    std::map<std::string, uint> warnings;               ///< the scene's and those found here: text -> how often
    std::map<std::string, std::string> warning_places;  ///< of both

    /// Words of a ray's or hit's entry in arrays of instances: with its time where some move.
    uint place_words() const { return instances ? moves ? 2 : 1 : 0; }
    /// Whether hits are brought together by their kind of BSDF, so that the list of a wave's rays is in another order than they.
    bool groups_hits() const { return paths && bsdfs.size() > 1; }
};

/// Is told which part of an accelerator is built, from 0 to 1, now and then, by any thread, but one at a time.
using WatchAccelerator = std::function<void(const AcceleratorKind &kind, double part)>;

/// What one buffer of a device holds.
struct ArenaLimit {
    std::size_t bytes = std::numeric_limits<std::size_t>::max();
    std::string device{};  ///< its name, for who reads the error
};

struct CompileOptions {
    Kinds kinds = Kinds::in_use;
    const AcceleratorKind *accelerator = nullptr;  ///< null: that which the scene asks for
    WatchAccelerator watch{};
    ArenaLimit limit{};
    bool computes_losses = true;  ///< else tables of what rough dielectrics' facets take from each other are 0, for who only asks what there is
};

/// Throws SceneError if the scene is too big, or names an unknown accelerator.
CompiledScene compile(const Scene &scene, const CompileOptions &options = {});

}  // namespace brandung
