#include "tools/bench/measure.h"

#include <algorithm>

namespace brandung {
namespace {

RayCounts difference(const RayCounts &after, const RayCounts &before) {
    RayCounts counts;
    for (std::size_t kind = 0; kind < RAY_KINDS; ++kind)
        counts.rays[kind] = after.rays[kind] - before.rays[kind], counts.hits[kind] = after.hits[kind] - before.hits[kind];
    return counts;
}

/// Adds what the profile has more than before.
void add_run(const Profile &before, const Profile &after, std::map<std::string, KernelRuns> &kernels) {
    for (const auto &[name, profile] : after) {
        const auto known = before.find(name);
        const KernelProfile earlier = known == before.end() ? KernelProfile() : known->second;
        if (profile.launches == earlier.launches) continue;
        KernelRuns &runs = kernels[name];
        runs.launches = profile.launches - earlier.launches, runs.items = profile.items - earlier.items;
        runs.bytes = profile.bytes ? std::optional(*profile.bytes - earlier.bytes.value()) : std::nullopt;
        runs.capacity = profile.capacity - earlier.capacity;
        runs.milliseconds.push_back(profile.milliseconds - earlier.milliseconds);
        runs.waiting_milliseconds.push_back(profile.waiting_milliseconds - earlier.waiting_milliseconds);
    }
}

}  // namespace

Measurements measure(Job &job, uint runs, const std::function<void(uint run)> &tell, const std::function<bool()> &goes_on) {
    Measurements all{{}, {}, {}, measure_limits(job.device), runs};
    const std::vector<Observer> observers = {{0.2, [&](const RenderProgress &) { return goes_on(); }}};
    for (uint run = 0; run <= runs && goes_on(); ++run) {
        tell(run);
        job.film.clear();
        job.device.finish();
        const Profile before = job.device.profile();
        const RayCounts counted = job.renderer.integrator().counts();
        double seconds = 0;
        const RenderEnd end = timed(seconds, [&] { return job.renderer.render(job.film, observers); });
        if (!end.failure.empty()) throw Error(end.failure);
        if (!end.complete()) break;
        if (run == 0) continue;  // kernels were compiled
        add_run(before, job.device.profile(), all.kernels);
        all.seconds.push_back(seconds);
        all.rays = difference(job.renderer.integrator().counts(), counted);
    }
    return all;
}

}  // namespace brandung
