/// Closed meshes are watertight, by every traversal and in accelerators of both qualities, and of a convex one a ray from inside meets exactly one
/// place.
#include "runtime/selftest/closed_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "kernels/selftest/all_hits.h"
#include "runtime/accelerators/ray_tracing.h"
#include "runtime/opencl/kernel.h"
#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/places.h"
#include "runtime/selftest/subjects/list.h"
#include "runtime/wavefront/device_scene.h"
#include "scene/primitives/add.h"

namespace brandung {
namespace {

constexpr std::size_t rays_per_mesh = 1 << 16;

CompiledScene compiled(const ClosedMesh &closed, BuildQuality quality) {
    Scene scene;
    scene.accelerator_quality = quality;
    scene.materials.emplace_back();
    add_triangle_mesh(scene, 0, closed.mesh);
    return compile(scene);
}

struct MeshOnDevice {
    MeshOnDevice(Device &device, const ClosedMesh &closed, BuildQuality quality)
        : closed(closed), scene(compiled(closed, quality)), on_device(device, scene), tracing(device, scene, on_device, rays_per_mesh) {}
    const ClosedMesh &closed;
    CompiledScene scene;
    DeviceScene on_device;
    RayTracing tracing;
};

class ClosedMeshes final : public Subject {
public:
    explicit ClosedMeshes(Device &device) : device_(device) {
        for (const ClosedMesh &closed : closed_meshes())
            for (const BuildQuality quality : {BuildQuality::fast, BuildQuality::high}) meshes_.emplace_back(device, closed, quality);
        kernel_.emplace(device, "kernels/selftest/all_hits.cl", "test_all_hits", meshes_.front().on_device.lists());
    }

    Findings examine(uint round) override {
        Findings findings;
        for (std::size_t mesh = 0; mesh < meshes_.size(); ++mesh) findings.add(examine(meshes_[mesh], seed_of(5, round, mesh)));
        device_.finish();
        return findings;
    }

private:
    struct Answers {
        const char *traversal;
        std::vector<Hit> hits;
        std::vector<std::uint8_t> visible;
    };

    std::vector<Answers> answers_of(MeshOnDevice &mesh, const std::vector<Ray> &rays) {
        const std::vector<uint> sources(rays.size(), 0);
        std::vector<Answers> all;
        for (const Traversal &traversal : traversals()) {
            if (!is_available(traversal, device_.info(), mesh.scene)) continue;
            mesh.tracing.trace({false, false, rays, sources}, traversal);
            all.push_back({traversal.name, mesh.tracing.answers().hits, {}});
            mesh.tracing.trace({true, false, rays, sources}, traversal);
            all.back().visible = mesh.tracing.answers().visible;
        }
        return all;
    }

    Findings examine(MeshOnDevice &mesh, std::uint64_t seed) {
        const ClosedMesh &closed = mesh.closed;
        std::vector<Ray> rays(rays_per_mesh);
        for_parts(rays.size(), [&](std::size_t first, std::size_t last) {
            InputSource source(seed_of(seed, 0, first));
            for (std::size_t i = first; i < last; ++i) rays[i] = ray_from_within(source, closed);
        });
        Buffer<MetPrimitives> met(device_, rays.size());
        (*kernel_)(rays.size(), mesh.on_device, Buffer<Ray>(device_, rays), static_cast<uint>(rays.size()), met);
        const std::vector<MetPrimitives> met_by = met.read();
        const std::vector<Answers> answers = answers_of(mesh, rays);
        return examine_each(rays.size(), [&](std::size_t i, Findings &findings) {
            const auto blame = [&](const std::string &what) {
                findings.blame([&] {
                    return fmt::format("{}: {}: ray from {} in direction {}", closed.name, what, text_of(rays[i].origin), text_of(rays[i].direction));
                });
            };
            const auto &[closest, all] = met_by[i];
            const std::span<const uint> faces(all, std::find(std::begin(all), std::end(all), NO_HIT));
            ++findings.hits;
            if (closest == NO_HIT || faces.empty()) return blame("gets out");
            for (const auto &[traversal, hits, visible] : answers) {
                if (hits[i].primitive == NO_HIT || visible[i] != 0) return blame(fmt::format("gets out of {}", traversal));
                if (hits[i].primitive != closest) blame(fmt::format("meets something else in {}", traversal));
            }
            if (closest != faces.front()) blame("the closest hit is not the first of all");
            findings.ambiguous += faces.size() == HIT_LIST_SIZE;  // what more it may meet is not known
            if (!closed.convex) return;
            if (const uint places = places_met(closed.mesh, rays[i], faces); places != 1) blame(fmt::format("meets {} places", places));
        });
    }

    Device &device_;
    std::deque<MeshOnDevice> meshes_;
    std::optional<Kernel> kernel_;
};

}  // namespace

void add_closed_meshes(std::vector<SubjectEntry> &list) {
    list.push_back({"closed_meshes", "primitives/triangle_crossing.cl, accelerators/wide_bvh.cl",
                    "every ray from inside meets one place or more, the same by every traversal, of convex meshes one; ambiguous: lists "
                    "of hits that are full",
                    1, [](Device &device) { return std::make_unique<ClosedMeshes>(device); }});
}

}  // namespace brandung
