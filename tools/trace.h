/// Trace: a timeline of a render for Perfetto (ui.perfetto.dev) and chrome://tracing, in the Trace Event Format of JSON.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "runtime/opencl/profiler.h"
#include "runtime/wavefront/ray_counter.h"
#include "runtime/wavefront/wave_step.h"

namespace brandung {

/// Collects what happens, and writes it at the end: about 40 bytes for each launch of a kernel. Times are seconds of the steady clock.
class Trace {
public:
    /// A part of the program's work, on a track of its own.
    void add_phase(const std::string &name, double start, double end) { add(phases, name, 0, start, end); }
    void add(const Build &build) { add(builds, build.file, 0, build.start, build.end); }
    void add(const Launch &launch) { add(launches, launch.kernel, launch.items, launch.start, launch.end); }
    /// Rays that wait, now.
    void add(const WaveStep &step);
    /// Rays so far, of which the speed of the time since the last call follows.
    void add(const RayCounts &counts);

    /// Throws SceneError if the file cannot be written.
    void write(const std::string &file, const std::string &title) const;

private:
    enum Track { phases, builds, launches };
    struct Event {
        Track track;
        uint name;  ///< its number in names_
        std::uint64_t items;
        double start, end;
    };
    struct Waiting {
        double time;
        std::vector<uint> rays;  ///< by generation
    };
    struct Speed {
        double time;
        std::array<double, RAY_KINDS> rays_per_second;
    };
    void add(Track track, const std::string &name, std::uint64_t items, double start, double end);

    std::map<std::string, uint> names_;
    std::vector<Event> events_;
    std::vector<Waiting> waiting_;
    std::vector<Speed> speeds_;
    RayCounts counts_;
    double counted_ = 0;
};

}  // namespace brandung
