#include "tools/bench/traversal.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "runtime/opencl/source.h"
#include "scene/cameras/camera.h"
#include "scene/error.h"
#include "tools/bench/candidate.h"
#include "tools/scene_options.h"

namespace brandung {
namespace {

/// Functions of Embree that take so many times as long in the first round as the fastest for the same scene are measured no more.
constexpr double slow = 2;

void append(RayAnswers &all, const RayAnswers &part) {
    all.hits.insert(all.hits.end(), part.hits.begin(), part.hits.end());
    all.instances.insert(all.instances.end(), part.instances.begin(), part.instances.end());
    all.visible.insert(all.visible.end(), part.visible.begin(), part.visible.end());
}

std::uint64_t count_different(const RayAnswers &a, const RayAnswers &b) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.count(); ++i) count += !a.is_same(b, i);
    return count;
}

class TraversalComparison {
public:
    TraversalComparison(Device &device, const Scene &scene, const TraversalTrial &trial)
        : device_(device),
          trial_(trial),
          name_(std::filesystem::path(scene.file).stem().string()),
          ours_(device, scene, trial.accelerator, trial.batch, [&](const CompiledScene &compiled) { geometry_ = geometry_of(scene, compiled); }) {
        const CompiledScene &compiled = ours_.compiled;
        result = {.scene = name_,
                  .accelerator = compiled.accelerator->name,
                  .primitives = compiled.primitive_count,
                  .instances = compiled.instance_count,
                  .node_bytes = compiled.node_bytes,
                  .block_bytes = compiled.block_bytes,
                  .build_seconds = {compiled.accelerator_seconds}};
        make_rays(scene);
        if (trial.embree && goes_on("Embree builds")) add_peer();
        build_again(scene);
    }

    /// Everything once, to warm up, and what it finds; false where it was ended.
    bool check() {
        return std::ranges::all_of(sets_,
                                   [&](const RaySet &set) { return check_ours(set) && (!peer_ || set.queue.count() == 0 || warm_up_peer(set)); });
    }

    /// One round, in which all take turns; false where it was ended.
    bool measure(uint round) {
        const std::string what = fmt::format("round {} of {}", round, trial_.runs);
        return std::ranges::all_of(
            sets_, [&](const RaySet &set) { return measure_ours(set, what) && (!peer_ || set.queue.count() == 0 || measure_peer(set, what)); });
    }

    TraversalResult result;

private:
    void make_rays(const Scene &scene) {
        goes_on("making rays");
        const CameraDescription &description = chosen_camera(scene, trial_.camera);
        if (description.kind != 0)
            throw SceneError(scene.file + ": camera \"" + description.name + "\" is " + camera_kinds()[description.kind].name +
                             "; traversals are compared by the rays of " + camera_kinds()[0].name + " ones");
        const Camera camera = make_camera(description, scene.film.width, scene.film.height);
        const auto find_hits = [&](const RayQueue &queue) {
            RayAnswers found;
            trace(queue, traversal_of_render(false, device_.info(), ours_.compiled), &found);
            return found;
        };
        sets_ = make_ray_sets(trial_.rays, camera, shadow_light(scene), geometry_, find_hits);
    }

    /// Ours by a compilation of its own, of which only the accelerator's time counts.
    void build_again(const Scene &scene) {
        for (uint build = 2; build <= trial_.builds && goes_on(fmt::format("build {} of {}", build, trial_.builds)); ++build) {
            const CompileOptions options = {.accelerator = ours_.compiled.accelerator, .limit = limit_of(device_)};
            result.build_seconds.push_back(compile(scene, options).accelerator_seconds);
            if (peer_) peer_->build_again();
        }
        if (peer_) result.peer_scenes = peer_->scenes();
    }

    void add_peer() {
        result.peer_refusal = EmbreePeer::refusal(geometry_);
        if (!result.peer_refusal.empty()) return;
        peer_.emplace(geometry_, device_.info().compute_units);
        judge_.emplace(geometry_);
        result.peer_version = peer_->version(), result.peer_width = peer_->native_width(), result.peer_instructions = peer_->instructions();
    }

    bool check_ours(const RaySet &set) {
        std::optional<RayAnswers> first, robust;
        std::optional<Disagreement> of_first;
        for (const Traversal &traversal : traversals()) {
            if (!is_available(traversal, device_.info(), ours_.compiled)) continue;
            if (!goes_on(set.name + ", warming up")) return false;
            RayAnswers found;
            trace(set.queue, traversal, &found);
            if (!first) first = found;
            TraversalRow &row = result.rows.emplace_back(row_of(set, traversal));
            row.different = count_different(found, *first);
            if (!peer_ || set.queue.count() == 0) continue;
            if (!robust) robust = robust_answers(set.queue);
            row.disagreement = of_first && row.different == 0
                                   ? of_first
                                   : compare_answers(*judge_, set.queue, found, *robust, [&] { return goes_on(set.name + ", judging"); });
            if (!row.disagreement) return false;
            if (!of_first) of_first = row.disagreement;
        }
        return true;
    }

    RayAnswers robust_answers(const RayQueue &queue) {
        const auto robust = std::ranges::find(peer_->scenes(), true, &PeerScene::robust);
        RayAnswers found;
        trace_by_peer(queue, static_cast<std::size_t>(robust - peer_->scenes().begin()), peer_apis.front(), &found);
        return found;
    }

    bool warm_up_peer(const RaySet &set) {
        for (std::size_t scene = 0; scene < peer_->scenes().size(); ++scene)
            for (const PeerApi &api : peer_apis) {
                if (!peer_->can_trace(api, set.queue.shadow)) continue;
                if (!goes_on(set.name + ", warming up Embree")) return false;
                trace_by_peer(set.queue, scene, api, nullptr);
                result.peers.push_back({set.name, scene, api, set.queue.count(), {}});
            }
        return true;
    }

    bool measure_ours(const RaySet &set, const std::string &what) {
        for (TraversalRow &row : result.rows) {
            if (row.rays != set.name) continue;
            if (!goes_on(fmt::format("{}, {}", set.name, what))) return false;
            const TraceSeconds seconds = trace(set.queue, *row.traversal, nullptr);
            row.wall_seconds.push_back(seconds.wall), row.device_seconds.push_back(seconds.device);
        }
        return true;
    }

    bool measure_peer(const RaySet &set, const std::string &what) {
        for (PeerRow &row : result.peers) {
            if (row.rays != set.name || (!row.seconds.empty() && row.seconds.front() > slow * fastest_peer(row))) continue;
            if (!goes_on(fmt::format("{}, {}, Embree", set.name, what))) return false;
            row.seconds.push_back(trace_by_peer(set.queue, row.scene, row.api, nullptr));
        }
        return true;
    }

    /// For the same rays in the same scene, in the first round [s].
    double fastest_peer(const PeerRow &like) const {
        double least = like.seconds.front();
        for (const PeerRow &row : result.peers)
            if (row.rays == like.rays && row.scene == like.scene && !row.seconds.empty()) least = std::min(least, row.seconds.front());
        return least;
    }

    /// In the batches that ours get, of which Embree has copies as it wants them before its time runs [s].
    double trace_by_peer(const RayQueue &queue, std::size_t scene, const PeerApi &api, RayAnswers *found) {
        double seconds = 0;
        for (std::size_t first = 0; first < queue.count(); first += trial_.batch) {
            peer_->take(part_of(queue, first, trial_.batch));
            seconds += peer_->trace(scene, api);
            if (found) append(*found, peer_->answers());
        }
        return seconds;
    }

    TraversalRow row_of(const RaySet &set, const Traversal &traversal) const {
        const char *kernel = set.queue.shadow ? traversal.any_hit : traversal.closest_hit;
        return {.rays = set.name,
                .traversal = &traversal,
                .of_render = &traversal == &traversal_of_render(set.queue.coherent, device_.info(), ours_.compiled),
                .count = set.queue.count(),
                .kernel = kernel,
                .hash = hash_of_text(expand_source(fmt::format("kernels/stages/{}.cl", kernel), specialize(ours_.compiled, traversal.lanes)))};
    }

    /// In batches; `found` takes the answers unless it is null.
    TraceSeconds trace(const RayQueue &queue, const Traversal &traversal, RayAnswers *found) {
        TraceSeconds sum{};
        for (std::size_t first = 0; first < queue.count(); first += trial_.batch) {
            const TraceSeconds seconds = ours_.tracing.trace(part_of(queue, first, trial_.batch), traversal);
            sum.device += seconds.device, sum.wall += seconds.wall;
            if (found) append(*found, ours_.tracing.answers());
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
    SceneGeometry geometry_;
    Candidate ours_;
    std::vector<RaySet> sets_;
    std::optional<EmbreePeer> peer_;
    std::optional<Judge> judge_;
};

}  // namespace

TraversalResult try_traversals(Device &device, const Scene &scene, const TraversalTrial &trial) {
    TraversalComparison comparison(device, scene, trial);
    bool goes_on = comparison.check();
    for (uint round = 1; goes_on && round <= trial.runs; ++round) goes_on = comparison.measure(round);
    return std::move(comparison.result);
}

}  // namespace brandung
