/// Observation: the records of a wave while its stages run, and what the stages write to when they run once more at throughput 1.
#pragma once
#include "runtime/integrators/wave_observer.h"
#include "runtime/wavefront/levels.h"

namespace brandung {

struct Observation {
    /// Of waves of at most so many rays; `children`: per ray, of those that a stage computes once more.
    Observation(Device &device, uint batch, uint children, uint interior_size, uint place_words);

    /// Before the wave's rays are traced, as `coherent` says, in their order then.
    void begin(const Wave &wave, bool coherent);
    /// The interfaces that they have met, and the order of all records, which is that of the wave's rays by now; `beyond`: the media behind, by item.
    void record_hits(const Wave &wave, const Buffer<Hit> &hits, const Buffer<uint> &instances, const Buffer<SurfacePoint> &points,
                     const Buffer<SurfaceInterface> &interfaces, const Buffer<vec3> &directions, const Buffer<uint> &beyond);
    /// A row of shadow rays, whose first slot this is, after they were traced; `filters` is null where shadows are not filtered. Sets `arriving`.
    void record_shadows(const Wave &wave, LightRecords &light, std::size_t slot, const Buffer<std::uint8_t> &visible,
                        const Buffer<Spectrum> *filters);
    /// Children as the stage has written them to the buffers below; `alive_below` is what it wrote for the next level, null at the last.
    void record_children(const Buffer<std::uint8_t> *alive_below);

    WaveRecords records;
    Buffer<Path> unit_paths;  ///< those of the wave's level, but as if from the eye: throughput is 1
    Buffer<Ray> rays;         ///< children from slot 0 on, as are the next four
    Buffer<Path> paths;
    Buffer<uint> sources;
    Buffer<uint> interiors;
    Buffer<std::uint8_t> alive;
    Buffer<std::uint8_t> all_visible;  ///< a row of shadow rays
    Buffer<Spectrum> arriving;         ///< the same: what arrives of the light
    Buffer<Spectrum> radiance;         ///< by item

private:
    void reorder(const Wave &wave);

    uint children_, place_words_;
};

}  // namespace brandung
