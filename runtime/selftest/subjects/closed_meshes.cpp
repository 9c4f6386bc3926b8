/// Closed meshes are watertight, and of a convex one a ray from inside meets exactly one place.
#include "runtime/selftest/closed_meshes.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernels/selftest/all_hits.h"
#include "runtime/opencl/kernel.h"
#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/places.h"
#include "runtime/selftest/subjects/list.h"
#include "runtime/wavefront/device_scene.h"
#include "scene/primitives/add.h"

namespace brandung {
namespace {

constexpr std::size_t rays_per_mesh = 1 << 17;

CompiledScene compiled(const ClosedMesh &closed) {
    Scene scene;
    scene.materials.emplace_back();
    add_triangle_mesh(scene, 0, closed.mesh);
    return compile(scene);
}

class ClosedMeshes final : public Subject {
public:
    explicit ClosedMeshes(Device &device) : device_(device) {
        for (const ClosedMesh &closed : closed_meshes()) scenes_.emplace_back(device, compiled(closed));
        kernel_.emplace(device, "kernels/selftest/all_hits.cl", "test_all_hits", scenes_.front().lists());
    }

    Findings examine(uint round) override {
        Findings findings;
        for (std::size_t mesh = 0; mesh < scenes_.size(); ++mesh)
            findings.add(examine(closed_meshes()[mesh], scenes_[mesh], seed_of(5, round, mesh)));
        device_.finish();
        return findings;
    }

private:
    Findings examine(const ClosedMesh &closed, const DeviceScene &scene, std::uint64_t seed) {
        std::vector<Ray> rays(rays_per_mesh);
        for_parts(rays.size(), [&](std::size_t first, std::size_t last) {
            InputSource source(seed_of(seed, 0, first));
            for (std::size_t i = first; i < last; ++i) rays[i] = ray_from_within(source, closed);
        });
        Buffer<MetPrimitives> met(device_, rays.size());
        (*kernel_)(rays.size(), scene, Buffer<Ray>(device_, rays), static_cast<uint>(rays.size()), met);
        const std::vector<MetPrimitives> met_by = met.read();
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
            if (closest != faces.front()) blame("the closest hit is not the first of all");
            findings.ambiguous += faces.size() == HIT_LIST_SIZE;  // what more it may meet is not known
            if (!closed.convex) return;
            if (const uint places = places_met(closed.mesh, rays[i], faces); places != 1) blame(fmt::format("meets {} places", places));
        });
    }

    Device &device_;
    std::vector<DeviceScene> scenes_;
    std::optional<Kernel> kernel_;
};

}  // namespace

void add_closed_meshes(std::vector<SubjectEntry> &list) {
    list.push_back({"closed_meshes", "primitives/triangle_crossing.cl, accelerators/wide_bvh.cl",
                    "every ray from inside meets one place or more, of convex meshes one; ambiguous: lists of hits that are full", 1,
                    [](Device &device) { return std::make_unique<ClosedMeshes>(device); }});
}

}  // namespace brandung
