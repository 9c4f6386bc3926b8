/// A compiled scene on a device.
#pragma once
#include "runtime/accelerators/traversals.h"
#include "runtime/opencl/access.h"

namespace brandung {

/// What one of its buffers holds.
inline ArenaLimit limit_of(const Device &device) { return {device.info().largest_allocation, device.info().name}; }

/// As kernel argument it is SCENE_PARAMS, header and arena, for kernels that look for something among the primitives.
class DeviceScene {
public:
    /// Copies records and texels to the device, and writes the generated files. Throws Error if one allocation of the device cannot hold the arena or
    /// the texels.
    DeviceScene(Device &device, const CompiledScene &scene) : DeviceScene(device, scene, traversal_of_render(false, device.info(), scene).lanes) {}
    /// For all kernels but those of traversals that are chosen for their rays.
    DeviceScene(Device &device, const CompiledScene &scene, RayLanes lanes)
        : header_(device, std::span(&scene.header, 1)),
          arena_(device, scene.arena),
          texels_(device, std::span<const Texel>(scene.texels)),
          lights_(scene.header.lights),
          lists_(specialize(scene, lanes)) {}

    template <class Bind> void for_each_argument(Bind bind) const { bind(shared(header_)), bind(data_dependent(arena_)); }
    /// The same for kernels that look nothing up but materials and lights, of which there are few.
    struct Tables {
        const DeviceScene &scene;
        template <class Bind> void for_each_argument(Bind bind) const { bind(shared(scene.header_)), bind(shared(scene.arena_)); }
    };
    Tables tables() const { return {*this}; }
    /// Replaces a light by one of the same kind, from the next launch on.
    void write_light(uint row, const Light &light) {
        arena_.write_bytes(std::size_t{64} * lights_.offset + sizeof light * row, std::as_bytes(std::span(&light, 1)));
    }
    /// The generated files of this scene.
    const Sources &lists() const { return lists_; }
    const Buffer<Texel> &texels() const { return texels_; }
    /// Of header and arena.
    std::size_t bytes() const { return header_.bytes() + arena_.bytes(); }
    std::size_t texture_bytes() const { return texels_.bytes(); }

private:
    Buffer<SceneHeader> header_;
    Buffer<std::byte> arena_;
    Buffer<Texel> texels_;  ///< empty in scenes without pictures
    Span lights_;
    Sources lists_;
};

}  // namespace brandung
