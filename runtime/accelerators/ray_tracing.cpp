#include "runtime/accelerators/ray_tracing.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "runtime/opencl/seconds_now.h"

namespace brandung {
namespace {

std::vector<uint> numbers_up_to(uint end) {
    std::vector<uint> numbers(end);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

Sources counting(Sources sources) {
    sources["generated/work.cl"] = "#include \"kernels/accelerators/work.cl\"\n";
    return sources;
}

double milliseconds_of(const Profile &profile) {
    double sum = 0;
    for (const auto &[name, kernel] : profile) sum += kernel.milliseconds;
    return sum;
}

}  // namespace

RaySpan part_of(const RayQueue &queue, std::size_t first, std::size_t count) {
    const std::size_t here = std::min(count, queue.count() - first);
    return {queue.shadow, queue.coherent, std::span(queue.rays).subspan(first, here), std::span(queue.sources).subspan(first, here)};
}

bool RayAnswers::is_same(const RayAnswers &other, std::size_t i) const {
    if (hits.empty()) return visible[i] == other.visible[i];
    return std::memcmp(&hits[i], &other.hits[i], sizeof(Hit)) == 0 && instances[i] == other.instances[i];
}

void WorkSums::add(const Work &work) {
    steps += work.steps, cells += work.cells, empty_cells += work.empty_cells, listed += work.listed;
    blocks += work.blocks, tests += work.tests, missed += work.missed, idle += work.idle, served += work.served;
}

void WorkSums::add(const WorkSums &sums) {
    rays += sums.rays, hits += sums.hits;
    steps += sums.steps, cells += sums.cells, empty_cells += sums.empty_cells, listed += sums.listed;
    blocks += sums.blocks, tests += sums.tests, missed += sums.missed, idle += sums.idle, served += sums.served;
}

RayTracing::RayTracing(Device &device, const CompiledScene &compiled, const DeviceScene &on_device, uint batch)
    : device_(device),
      compiled_(compiled),
      scene_(on_device),
      together_(traversal_of_render(true, device.info(), compiled)),
      apart_(traversal_of_render(false, device.info(), compiled)),
      rays_(device, batch),
      sources_(device, batch),
      live_(device, numbers_up_to(batch)),
      counts_(device, 1),
      hits_(device, batch),
      instances_(device, std::vector<uint>(batch, 0)),
      crowded_(device, batch),
      visible_(device, batch),
      works_(device, batch),
      tallies_(device, 0),
      batch_(batch) {}

Kernel &RayTracing::stage(const Traversal &traversal, const char *Traversal::*question) {
    const std::pair<std::string, std::string> names{traversal.name, traversal.*question};
    const auto known = stages_.find(names);
    if (known != stages_.end()) return known->second;
    return stages_.emplace(names, traversal_kernel(device_, traversal, question, compiled_, Times::first)).first->second;
}

Kernel &RayTracing::counter(const std::string &name) {
    const auto known = counters_.find(name);
    if (known != counters_.end()) return known->second;
    return counters_.emplace(name, Kernel(device_, "kernels/bench/count_work.cl", name, counting(specialize(compiled_, apart_.lanes, Times::first))))
        .first->second;
}

void RayTracing::take(const RaySpan &rays) {
    rays_.write(rays.rays), sources_.write(rays.sources);
    const auto count = static_cast<uint>(rays.rays.size());
    counts_.write(std::span(&count, 1));
    if (rays.shadow) visible_.write(std::vector<std::uint8_t>(count, 1));
    taken_ = rays;
    device_.finish();
}

TraceSeconds RayTracing::trace(const RaySpan &rays) { return trace(rays, rays.coherent ? together_ : apart_); }

TraceSeconds RayTracing::trace(const RaySpan &rays, const Traversal &traversal) {
    take(rays);
    Kernel &kernel = stage(traversal, rays.shadow ? &Traversal::any_hit : &Traversal::closest_hit);
    if (const std::size_t work_items = kernel.work_items(rays.rays.size()); work_items > tallies_.size()) {
        tallies_ = Buffer<Tally>(device_, work_items);
        tallies_.fill_zero();
    }
    const double before = milliseconds_of(device_.profile()), start = seconds_now();
    launch(rays, kernel);
    device_.finish();
    const double wall = seconds_now() - start;
    return {1e-3 * (milliseconds_of(device_.profile()) - before), wall};
}

void RayTracing::launch(const RaySpan &rays, Kernel &kernel) {
    const auto count = static_cast<uint>(rays.rays.size());
    if (rays.shadow) {
        kernel(count, scene_, live_, counts_, batch_, rays_, sources_, visible_, tallies_);
    } else {
        kernel(count, scene_, live_, 0u, count, rays_, sources_, hits_, instances_, crowded_, tallies_);
    }
}

RayAnswers RayTracing::answers() const {
    const std::size_t count = taken_.rays.size();
    if (taken_.shadow) return {{}, {}, visible_.read(0, count)};
    return {hits_.read(0, count), instances_.read(0, count), {}};
}

RayAnswers RayTracing::count(const RaySpan &rays, WorkSums &sums) {
    take(rays);
    const auto count = static_cast<uint>(rays.rays.size());
    if (rays.shadow) {
        counter("count_shadows")(count, scene_, count, rays_, sources_, visible_, works_);
    } else {
        counter("count_closest_hits")(count, scene_, count, rays_, sources_, hits_, instances_, works_);
    }
    RayAnswers found = answers();
    for (const Work &work : works_.read(0, count)) sums.add(work);
    sums.rays += count;
    for (const Hit &hit : found.hits) sums.hits += hit.primitive != NO_HIT;
    for (const std::uint8_t visible : found.visible) sums.hits += visible == 0;
    return found;
}

}  // namespace brandung
