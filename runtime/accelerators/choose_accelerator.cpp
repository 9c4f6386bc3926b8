#include "runtime/accelerators/choose_accelerator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/accelerators/ray_tracing.h"
#include "runtime/opencl/seconds_now.h"

namespace brandung {
namespace {

constexpr std::size_t rays_of_each_use = 16384;  ///< some ten milliseconds' worth: what is taken by mistake then is hardly slower
constexpr int rounds = 5;
constexpr std::size_t most_without = 256;  ///< primitives among which none may be the best

/// A sample of the render's rays, and for each of its queues how many rays of the render one of it stands for.
struct WeighedSample {
    RaySample queues;
    std::vector<double> weights;
    double rays = 0;  ///< of the render

    std::uint64_t count() const {
        std::uint64_t count = 0;
        for (const RayQueue &queue : queues) count += queue.count();
        return count;
    }
};

double rays_of(const RayCounts &counts, RayQueue::Use use) {
    if (use == RayQueue::Use::camera) return double(counts.rays[RAY_CAMERA]);
    if (use == RayQueue::Use::shadow) return double(counts.rays[RAY_SHADOW]);
    return double(counts.rays[RAY_REFLECTED] + counts.rays[RAY_REFRACTED]);
}

/// Which accelerator gives the sample does not matter: all trace the same rays.
WeighedSample sample_of(Device &device, const Scene &scene, const CameraDescription &camera, uint batch, const CompiledScene &compiled,
                        const DeviceScene &on_device) {
    Renderer renderer(device, scene, compiled, on_device, camera, {.batch = batch});
    const Window window = scene.film.window();
    WeighedSample sample{sample_rays(renderer, window, batch, rays_of_each_use), {}, 0};
    const RayCounts counts = renderer.integrator().counts();
    const double samples = double(window.width()) * window.height() * scene.film.spp, renders = samples / double(counts.rays[RAY_CAMERA]);
    for (const RayQueue &queue : sample.queues) {
        sample.weights.push_back(renders * rays_of(counts, queue.use) / double(std::max<std::size_t>(1, count_of(sample.queues, queue.use))));
        sample.rays += sample.weights.back() * double(queue.count());
    }
    return sample;
}

/// Of the whole render, by the median of some rounds. Ends after one that takes longer than `limit`.
double trace(RayTracing &tracing, const WeighedSample &sample, uint batch, double limit) {
    std::vector<double> seconds;
    for (int round = 0; round <= rounds; ++round) {
        double sum = 0;
        for (std::size_t q = 0; q < sample.queues.size(); ++q)
            for (std::size_t first = 0; first < sample.queues[q].count(); first += batch)
                sum += sample.weights[q] * tracing.trace(part_of(sample.queues[q], first, batch)).device;
        if (round > 0) seconds.push_back(sum);  // the first warms up
        if (round > 0 && sum > limit) break;
    }
    std::ranges::nth_element(seconds, seconds.begin() + std::ptrdiff_t(seconds.size() / 2));
    return seconds[seconds.size() / 2];
}

/// Thrown through a build that takes too long.
struct GivenUp {};

/// Nothing if it takes longer than `limit` [s].
std::optional<CompiledScene> build(const Device &device, const Scene &scene, const AcceleratorKind &kind, double limit,
                                   const WatchAccelerator &watch) {
    const double start = seconds_now();
    const auto goes_on = [&](const AcceleratorKind &built, double part) {
        if (seconds_now() - start > limit) throw GivenUp();
        if (watch) watch(built, part);
    };
    try {
        return compile(scene, {.accelerator = &kind, .watch = goes_on, .limit = limit_of(device)});
    } catch (const GivenUp &) {
        return {};
    }
}

}  // namespace

AcceleratorChoice choose_accelerator(Device &device, const Scene &scene, const CameraDescription &camera, uint batch, const ChoiceWatch &watch) {
    AcceleratorChoice choice;
    std::optional<WeighedSample> sample;
    double best = std::numeric_limits<double>::infinity();
    for (const AcceleratorKind &kind : accelerator_kinds()) {
        if (watch.on_trial) watch.on_trial(kind);
        TriedAccelerator trial{.kind = &kind, .trace_seconds = std::numeric_limits<double>::infinity()};
        const double start = seconds_now(), limit = std::max(1.0, 2 * best);
        const std::optional<CompiledScene> compiled = build(device, scene, kind, limit, watch.on_accelerator);
        if (!compiled) {
            trial.build_seconds = seconds_now() - start;
        } else if (trial.build_seconds = compiled->accelerator_seconds;
                   std::string(kind.name) != "none" || compiled->primitive_count <= most_without) {
            const DeviceScene on_device(device, *compiled);
            if (!sample) sample = sample_of(device, scene, camera, batch, *compiled, on_device);
            RayTracing tracing(device, *compiled, on_device, batch);
            trial.trace_seconds = trace(tracing, *sample, batch, 4 * best);
        } else {
            continue;
        }
        best = std::min(best, trial.expected_seconds());
        choice.trials.push_back(trial);
    }
    std::ranges::stable_sort(choice.trials, {}, &TriedAccelerator::expected_seconds);
    choice.rays = std::uint64_t(sample->rays + 0.5), choice.rays_tried = sample->count();
    return choice;
}

std::string text_of(const AcceleratorChoice &choice) {
    std::vector<std::string> parts;
    for (const TriedAccelerator &trial : choice.trials)
        parts.push_back(std::isinf(trial.trace_seconds)
                            ? fmt::format("{} given up after {:.2g} s of building", trial.kind->name, trial.build_seconds)
                            : fmt::format("{} {:.3g} s ({:.2g} of them to build)", trial.kind->name, trial.expected_seconds(), trial.build_seconds));
    return fmt::format("chosen by auto, which traced {} of some {} rays with each: {}", choice.rays_tried, choice.rays, fmt::join(parts, ", "));
}

}  // namespace brandung
