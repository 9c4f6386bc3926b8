#include "tools/bench/accelerators.h"

#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <numeric>

#include "tools/bench/candidate.h"
#include "tools/bench/random_rays.h"

namespace brandung {
namespace {

AcceleratorRow row_of(const Scene &scene, const Candidate &candidate) {
    const CompiledScene &compiled = candidate.compiled;
    return {.scene = std::filesystem::path(scene.file).stem().string(),
            .accelerator = compiled.accelerator->name,
            .packets = compiled.accelerator->packets,
            .primitives = compiled.primitive_count,
            .instances = compiled.instance_count,
            .node_bytes = compiled.node_bytes,
            .block_bytes = compiled.block_bytes,
            .build_seconds = compiled.accelerator_seconds};
}

std::size_t place(RayQueue::Use use) { return static_cast<std::size_t>(use); }

class Comparison {
public:
    Comparison(Job &job, const AcceleratorTrial &trial) : trial_(trial), name_(std::filesystem::path(job.scene.file).stem().string()) {
        const Scene &scene = job.scene;
        queues_ = sample_rays(job.renderer, scene.film.window(), trial.batch, trial.most_rays, [&](double part) { return goes_on("rays", part); });
        for (RayQueue &queue : random_rays(scene, trial.random_rays)) queues_.push_back(std::move(queue));
        if (trial.check) reference_.emplace(job.device, scene, "none", trial.batch);
        for (const std::string &accelerator : trial.accelerators) {
            trial_.tell(fmt::format("{}: {}", name_, accelerator));
            rows.push_back(row_of(scene, candidates_.emplace_back(job.device, scene, accelerator, trial.batch)));
        }
    }

    /// Every ray through every accelerator, one ray after another and as in a render; false where it was ended.
    bool count() {
        const std::size_t all = std::accumulate(queues_.begin(), queues_.end(), std::size_t{0}, [](auto n, const auto &q) { return n + q.count(); });
        std::size_t done = 0;
        for (const RayQueue &queue : queues_)
            for (std::size_t first = 0; first < queue.count(); first += trial_.batch) {
                if (!goes_on("counting", static_cast<double>(done) / static_cast<double>(all))) return false;
                count(queue, part_of(queue, first, trial_.batch));
                done += std::min<std::size_t>(trial_.batch, queue.count() - first);
            }
        return true;
    }

    /// One round of times: accelerator by accelerator, so that what else the machine does slows all of them. False where it was ended.
    bool measure(uint round) {
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            const double part = double(i) / double(candidates_.size());
            std::array<double, ray_uses> seconds{};
            for (const RayQueue &queue : queues_) {
                if (queue.use == RayQueue::Use::random) continue;
                for (std::size_t first = 0; first < queue.count(); first += trial_.batch) {
                    if (!goes_on(fmt::format("round {} of {}", round + 1, trial_.runs).c_str(), part)) return false;
                    seconds[place(queue.use)] += candidates_[i].tracing.trace(part_of(queue, first, trial_.batch)).device;
                }
            }
            for (std::size_t use = 0; use < ray_uses; ++use)
                if (seconds[use] > 0) rows[i].uses[use].seconds.push_back(seconds[use]);
        }
        return true;
    }

    std::vector<AcceleratorRow> rows;

private:
    void count(const RayQueue &queue, const RaySpan &rays) {
        RayAnswers expected;
        if (reference_) {
            RaySpan singly = rays;
            singly.coherent = false;
            reference_->tracing.trace(singly);
            expected = reference_->tracing.answers();
        }
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            UseOfRays &use = rows[i].uses[place(queue.use)];
            candidates_[i].tracing.trace(rays);
            const RayAnswers found = candidates_[i].tracing.answers(), counted = candidates_[i].tracing.count(rays, use.work);
            for (std::size_t k = 0; k < found.count(); ++k)
                use.different += !found.is_same(counted, k) || (reference_ && !found.is_same(expected, k));
        }
    }

    bool goes_on(const char *what, double part) const {
        trial_.tell(fmt::format("{}: {}, {:.0f} %", name_, what, 100 * part));
        return trial_.goes_on();
    }

    const AcceleratorTrial &trial_;
    std::string name_;
    std::vector<RayQueue> queues_;
    std::optional<Candidate> reference_;
    std::deque<Candidate> candidates_;
};

}  // namespace

std::uint64_t AcceleratorRow::different() const {
    std::uint64_t sum = 0;
    for (const UseOfRays &use : uses) sum += use.different;
    return sum;
}

std::vector<AcceleratorRow> try_accelerators(Job &job, const AcceleratorTrial &trial) {
    Comparison comparison(job, trial);
    bool goes_on = comparison.count();
    for (uint round = 0; goes_on && round < trial.runs; ++round) goes_on = comparison.measure(round);
    return std::move(comparison.rows);
}

}  // namespace brandung
