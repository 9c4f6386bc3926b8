/// Trace: a timeline of a render for Perfetto (ui.perfetto.dev) and chrome://tracing, in the Trace Event Format of JSON.
#pragma once
#include <string>

#include "runtime/opencl/profiler.h"
#include "runtime/wavefront/ray_counter.h"
#include "runtime/wavefront/wave_step.h"
#include "scene/output.h"

namespace brandung {

/// Writes what happens as it happens: about 100 bytes for each launch of a kernel, and nothing is kept. Times are seconds of the steady clock.
class Trace {
public:
    /// Times in the file are those since `start`. Throws SceneError if the file cannot be written.
    Trace(const std::string &file, const std::string &title, double start);

    /// A part of the program's work, on a track of its own.
    void add_phase(const std::string &name, double start, double end) { add(phases, name, start, end, ""); }
    void add(const Build &build) { add(builds, build.file, build.start, build.end, ""); }
    void add(const Launch &launch);
    /// Rays that wait, now.
    void add(const WaveStep &step);
    /// Rays so far, of which the speed of the time since the last call follows.
    void add(const RayCounts &counts);

    /// Throws SceneError if not all could be written.
    void finish() { text_.finish(); }

private:
    enum Track { phases, builds, launches };
    void add(Track track, const std::string &name, double start, double end, const std::string &more);
    /// Microseconds since the beginning.
    double time(double seconds) const { return (seconds - start_) * 1e6; }

    GrowingText text_;
    double start_;
    RayCounts counts_;
    double counted_ = 0;
};

}  // namespace brandung
