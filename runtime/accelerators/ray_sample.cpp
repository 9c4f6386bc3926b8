#include "runtime/accelerators/ray_sample.h"

#include <algorithm>
#include <cmath>

#include "runtime/accelerators/traversals.h"
#include "runtime/wavefront/work.h"

namespace brandung {
namespace {

constexpr std::size_t run = ITEMS_PER_CHUNK;  ///< pixels of a block, and rays of a work-item

/// The first run of a list, and further ones evenly spread behind it, so that about this share of the items is left.
template <class T> std::vector<T> thinned(const std::vector<T> &items, double share) {
    std::vector<T> kept;
    for (std::size_t first = 0, number = 0; first < items.size(); first += run, ++number) {
        if (std::ceil(share * double(number)) == std::ceil(share * double(number + 1))) continue;
        kept.insert(kept.end(), items.begin() + std::ptrdiff_t(first), items.begin() + std::ptrdiff_t(std::min(first + run, items.size())));
    }
    return kept;
}

/// The part of `count` items that are kept where at most so many are.
double share_of(std::size_t count, std::size_t most) { return count <= most ? 1.0 : static_cast<double>(most) / static_cast<double>(count); }

RaySample empty_sample() {
    using enum RayQueue::Use;
    return {{camera, false, true, {}, {}},
            {secondary, false, true, {}, {}},
            {secondary, false, false, {}, {}},
            {shadow, true, true, {}, {}},
            {shadow, true, false, {}, {}}};
}

/// Takes the rays of the waves that it is shown.
class RayCollector : public WaveObserver {
public:
    explicit RayCollector(RaySample &sample) : sample_(sample) {}

    void see(const WaveRecords &wave) override {
        RayQueue &closest = sample_[wave.generation == 0 ? 0 : wave.coherent ? 1 : 2];
        for (const uint i : wave.traced) closest.rays.push_back(wave.begun[i]), closest.sources.push_back(wave.begun_instances[i]);
        RayQueue &shadows = sample_[are_shadow_rays_coherent(wave.generation) ? 3 : 4];
        for (const LightBlockRecords &block : wave.lights)
            for (const LightRecords &light : block.lights) add_row(shadows, light, wave.instances);
    }
    void end(const std::vector<Sample> &) override {}

private:
    static void add_row(RayQueue &queue, const LightRecords &light, const std::vector<uint> &instances) {
        for (std::size_t i = 0; i < light.rays.size(); ++i) {
            if (light.asked[i] == 0) continue;
            queue.rays.push_back(light.rays[i]);
            queue.sources.push_back(instances[i]);
        }
    }

    RaySample &sample_;
};

void thin(RaySample &sample, std::size_t most) {
    for (const RayQueue::Use use : {RayQueue::Use::camera, RayQueue::Use::secondary, RayQueue::Use::shadow}) {
        const double share = share_of(count_of(sample, use), most);
        if (share == 1) continue;
        for (RayQueue &queue : sample)
            if (queue.use == use) queue.rays = thinned(queue.rays, share), queue.sources = thinned(queue.sources, share);
    }
}

}  // namespace

RaySample sample_rays(Renderer &renderer, const Window &window, uint batch, std::size_t most, const std::function<bool(double part)> &goes_on) {
    RaySample sample = empty_sample();
    RayCollector collector(sample);
    const std::vector<uint> all = PixelOrder(window).next(window.pixels()), pixels = thinned(all, share_of(all.size(), most));
    for (std::size_t first = 0; first < pixels.size(); first += batch) {
        const std::size_t end = std::min(first + batch, pixels.size());
        renderer.show({pixels.begin() + std::ptrdiff_t(first), pixels.begin() + std::ptrdiff_t(end)}, 0, 1, collector);
        if (goes_on && !goes_on(static_cast<double>(end) / static_cast<double>(pixels.size()))) break;
    }
    thin(sample, most);
    return sample;
}

std::size_t count_of(const RaySample &sample, RayQueue::Use use) {
    std::size_t count = 0;
    for (const RayQueue &queue : sample) count += queue.use == use ? queue.count() : 0;
    return count;
}

}  // namespace brandung
