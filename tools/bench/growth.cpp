#include "tools/bench/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <set>

#include "tools/bench/candidate.h"
#include "tools/bench/growing_scenes.h"

namespace brandung {
namespace {

RayQueue first_rays(const RayQueue &queue, std::size_t count) {
    const auto end = static_cast<std::ptrdiff_t>(count);
    return {queue.use,
            queue.shadow,
            queue.coherent,
            {queue.rays.begin(), queue.rays.begin() + end},
            {queue.sources.begin(), queue.sources.begin() + end}};
}

/// All accelerators of one scene of one size.
class GrowthStep {
public:
    GrowthStep(Device &device, const GrowthTrial &trial, const std::string &scene, uint objects)
        : device_(device), trial_(trial), name_(scene), objects_(objects), scene_(growing_scene(scene, objects)), queues_(rays_in_cube(trial.rays)) {}

    /// False where it was ended.
    bool build(const std::string &accelerator) {
        if (!goes_on(accelerator)) return false;
        const CompiledScene &compiled = candidates_.emplace_back(device_, scene_, accelerator, trial_.batch).compiled;
        const bool few = accelerator == std::string("none");
        rows.push_back({.scene = name_,
                        .accelerator = accelerator,
                        .objects = objects_,
                        .build_seconds = compiled.accelerator_seconds,
                        .bytes = compiled.node_bytes + compiled.block_bytes,
                        .rays = few ? std::clamp<std::size_t>(most_pairs / objects_, 1, trial_.rays) : trial_.rays,
                        .closest = {},
                        .any = {}});
        return true;
    }

    /// One ray after another.
    bool count() {
        return for_all("counting", [&](std::size_t i, const RaySpan &rays) {
            GrowthRow &row = rows[i];
            candidates_[i].tracing.count(rays, rays.shadow ? row.any.work : row.closest.work);
        });
    }

    /// One round, in which accelerators take turns.
    bool measure(uint round) {
        std::vector<std::array<double, 2>> seconds(rows.size());
        const bool whole = for_all(fmt::format("round {} of {}", round, trial_.runs),
                                   [&](std::size_t i, const RaySpan &rays) { seconds[i][rays.shadow] += candidates_[i].tracing.trace(rays).device; });
        if (!whole) return false;
        for (std::size_t i = 0; round > 0 && i < rows.size(); ++i)
            rows[i].closest.seconds.push_back(seconds[i][0]), rows[i].any.seconds.push_back(seconds[i][1]);
        return true;
    }

    std::vector<GrowthRow> rows;

private:
    template <class Use> bool for_all(const std::string &what, Use use) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const RayQueue &all : queues_) {
                const RayQueue queue = first_rays(all, rows[i].rays);
                for (std::size_t first = 0; first < queue.count(); first += trial_.batch) {
                    if (!goes_on(fmt::format("{}, {}", rows[i].accelerator, what))) return false;
                    use(i, part_of(queue, first, trial_.batch));
                }
            }
        return true;
    }

    bool goes_on(const std::string &what) const {
        trial_.tell(fmt::format("{}, {} objects: {}", name_, objects_, what));
        return trial_.goes_on();
    }

    Device &device_;
    const GrowthTrial &trial_;
    std::string name_;
    uint objects_;
    Scene scene_;
    std::vector<RayQueue> queues_;
    std::deque<Candidate> candidates_;
};

/// Of one scene.
class GrowthOfScene {
public:
    GrowthOfScene(Device &device, const GrowthTrial &trial, Growth &growth) : device_(device), trial_(trial), growth_(growth) {}

    /// False where it was ended.
    bool add(const std::string &scene, uint objects) {
        GrowthStep step(device_, trial_, scene, objects);
        for (const std::string &accelerator : trial_.accelerators)
            if (!too_slow_.contains(accelerator) && !step.build(accelerator)) return false;
        bool goes_on = step.count();
        for (uint round = 0; goes_on && round <= trial_.runs; ++round) goes_on = step.measure(round);  // the first to warm up
        for (GrowthRow &row : step.rows) add(std::move(row));
        return goes_on;
    }

private:
    void add(GrowthRow row) {
        if (row.closest.seconds.empty()) return;
        if (row.build_seconds > longest_build && too_slow_.insert(row.accelerator).second)
            growth_.notes.push_back(fmt::format("{} of {}: building it of {} objects took {:.0f} s: left out for more", row.accelerator, row.scene,
                                                row.objects, row.build_seconds));
        if (row.rays < trial_.rays)
            growth_.notes.push_back(fmt::format("{} of {}, {} objects: {} rays only", row.accelerator, row.scene, row.objects, row.rays));
        growth_.rows.push_back(std::move(row));
    }

    Device &device_;
    const GrowthTrial &trial_;
    Growth &growth_;
    std::set<std::string> too_slow_;
};

}  // namespace

Growth measure_growth(Device &device, const GrowthTrial &trial) {
    Growth growth;
    std::vector<uint> sizes = trial.objects;
    std::sort(sizes.begin(), sizes.end());
    for (const std::string &scene : trial.scenes) {
        GrowthOfScene of_scene(device, trial, growth);
        for (const uint objects : sizes)
            if (!of_scene.add(scene, objects)) return growth;
    }
    return growth;
}

}  // namespace brandung
