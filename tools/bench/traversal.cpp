#include "tools/bench/traversal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "runtime/opencl/source.h"
#include "scene/accelerators/accelerator.h"
#include "scene/lights/light.h"
#include "tools/scene_options.h"

namespace brandung {
namespace {

/// Whether both say that a ray meets the same primitive, or none.
bool is_same_hit(const RayAnswers &a, const RayAnswers &b, std::size_t i) {
    if (a.hits.empty()) return (a.visible[i] != 0) == (b.visible[i] != 0);
    return a.hits[i].primitive == b.hits[i].primitive && (a.hits[i].primitive == NO_HIT || a.instances[i] == b.instances[i]);
}

/// A point or spot light's place, both of whose words begin with it; without one, above the middle of all, as high as it is wide.
vec3 light_of(const Scene &scene) {
    for (const Light &light : scene.lights) {
        const std::string kind = light_kinds()[light.kind].name;
        if (kind != "point" && kind != "spot") continue;
        vec3 position;
        std::memcpy(&position, light.words, sizeof position);
        return position;
    }
    Bounds box;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) box.add(shape->bounds(i));
    for (const PlacedGroup &instance : scene.instances) box.add(instance.bounds);
    if (box.empty()) return {0, 1, 0};
    const vec3 size = box.high - box.low;
    return {0.5f * (box.low.x + box.high.x), box.high.y + std::max(size.x, size.z), 0.5f * (box.low.z + box.high.z)};
}

std::uint64_t hash_of(const std::string &text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

class TraversalComparison {
public:
    TraversalComparison(Device &device, const Scene &scene, const TraversalTrial &trial)
        : device_(device),
          trial_(trial),
          name_(std::filesystem::path(scene.file).stem().string()),
          compiled_(compile(scene, {.accelerator = &find_accelerator(trial.accelerator)})),
          on_device_(device, compiled_),
          tracing_(device, compiled_, on_device_, trial.batch),
          geometry_(geometry_of(scene, compiled_)) {
        compiled_.arena = {};  // the device has it
        result = {.scene = name_,
                  .accelerator = compiled_.accelerator->name,
                  .primitives = compiled_.primitive_count,
                  .instances = compiled_.instance_count,
                  .node_bytes = compiled_.node_bytes,
                  .block_bytes = compiled_.block_bytes,
                  .build_seconds = compiled_.accelerator_seconds};
        goes_on("making rays");
        const Camera camera = make_camera(chosen_camera(scene, trial.camera), scene.film.width, scene.film.height);
        sets_ = make_ray_sets(trial.rays, camera, light_of(scene), geometry_, [&](const RayQueue &queue) {
            RayAnswers found;
            trace(queue, traversals().back(), &found);
            return found;
        });
        goes_on("Embree builds");
        if (trial.embree) add_peer();
    }

    /// Everything once, to warm up, and what it finds; false where it was ended.
    bool check() {
        for (const RaySet &set : sets_) {
            RayAnswers first, robust;
            if (peer_) {
                peer_->take(set.queue);
                peer_->trace(peer_->scenes().size() - 1, peer_apis[0]);
                robust = peer_->answers();
            }
            for (const Traversal &traversal : traversals()) {
                if (!is_available(traversal, device_, compiled_)) continue;
                if (!goes_on(fmt::format("{}, warming up", set.name))) return false;
                RayAnswers found;
                trace(set.queue, traversal, &found);
                if (first.count() == 0) first = found;
                TraversalRow &row = result.rows.emplace_back(row_of(set, traversal));
                for (std::size_t i = 0; i < found.count(); ++i) {
                    row.different += !found.is_same(first, i);
                    if (peer_) row.mismatches += !is_same_hit(found, robust, i);
                }
            }
            if (!peer_) continue;
            for (const PeerScene &scene : peer_->scenes())
                for (const PeerApi &api : peer_apis) result.peers.push_back({set.name, scene.name, api.name(), scene.robust, set.queue.count(), {}});
        }
        return true;
    }

    /// One round, in which all take turns; false where it was ended.
    bool measure(uint round) {
        std::size_t row = 0, peer_row = 0;
        for (const RaySet &set : sets_) {
            for (const Traversal &traversal : traversals()) {
                if (!is_available(traversal, device_, compiled_)) continue;
                if (!goes_on(fmt::format("{}, round {} of {}", set.name, round, trial_.runs))) return false;
                const TraceSeconds seconds = trace(set.queue, traversal, nullptr);
                if (round > 0) result.rows[row].seconds.push_back(seconds.wall), result.rows[row].device_seconds.push_back(seconds.device);
                ++row;
            }
            if (!peer_) continue;
            peer_->take(set.queue);
            for (std::size_t scene = 0; scene < peer_->scenes().size(); ++scene)
                for (const PeerApi &api : peer_apis) {
                    if (!goes_on(fmt::format("{}, round {} of {}, Embree", set.name, round, trial_.runs))) return false;
                    const double seconds = peer_->trace(scene, api);
                    if (round > 0) result.peers[peer_row].seconds.push_back(seconds);
                    ++peer_row;
                }
        }
        return true;
    }

    TraversalResult result;

private:
    void add_peer() {
        peer_.emplace(geometry_, device_.info().compute_units);
        result.peer_version = peer_->version(), result.peer_width = peer_->native_width(), result.peer_scenes = peer_->scenes();
    }

    TraversalRow row_of(const RaySet &set, const Traversal &traversal) const {
        const char *kernel = set.queue.shadow ? traversal.any_hit : traversal.closest_hit;
        return {.rays = set.name,
                .variant = traversal.name,
                .kernel = kernel,
                .kernel_hash = hash_of(expand_source(fmt::format("kernels/stages/{}.cl", kernel), on_device_.lists())),
                .count = set.queue.count(),
                .of_render = &traversal == &traversal_of_render(set.queue.coherent, device_, compiled_)};
    }

    /// In batches; `found` takes the answers unless it is null.
    TraceSeconds trace(const RayQueue &queue, const Traversal &traversal, RayAnswers *found) {
        TraceSeconds sum{};
        for (std::size_t first = 0; first < queue.count(); first += trial_.batch) {
            const TraceSeconds seconds = tracing_.trace(part_of(queue, first, trial_.batch), traversal);
            sum.device += seconds.device, sum.wall += seconds.wall;
            if (!found) continue;
            const RayAnswers part = tracing_.answers();
            found->hits.insert(found->hits.end(), part.hits.begin(), part.hits.end());
            found->instances.insert(found->instances.end(), part.instances.begin(), part.instances.end());
            found->visible.insert(found->visible.end(), part.visible.begin(), part.visible.end());
        }
        return sum;
    }

    bool goes_on(const std::string &what) const {
        trial_.tell(fmt::format("{}: {}", name_, what));
        return trial_.goes_on();
    }

    Device &device_;
    const TraversalTrial &trial_;
    std::string name_;
    CompiledScene compiled_;
    DeviceScene on_device_;
    RayTracing tracing_;
    SceneGeometry geometry_;
    std::vector<RaySet> sets_;
    std::optional<EmbreePeer> peer_;
};

}  // namespace

TraversalResult try_traversals(Device &device, const Scene &scene, const TraversalTrial &trial) {
    TraversalComparison comparison(device, scene, trial);
    bool goes_on = comparison.check();
    for (uint round = 0; goes_on && round <= trial.runs; ++round) goes_on = comparison.measure(round);
    return std::move(comparison.result);
}

}  // namespace brandung
