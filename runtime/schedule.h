/// Schedule: how many samples the passes of a render take, and when it ends.
#pragma once
#include <optional>

#include "runtime/wavefront/noise.h"
#include "scene/scene.h"

namespace brandung {

/// When a render ends, if not before by its number of samples.
struct StopRules {
    std::optional<double> error;    ///< once the noise's relMSE is below this with its interval's upper end
    std::optional<double> seconds;  ///< once it has taken so long since its first batch, but not before every pixel has a sample
};

class Schedule {
public:
    /// `batch`: rays per wave.
    Schedule(const FilmSettings &film, uint batch, const StopRules &rules) : film_(film), batch_(batch), rules_(rules) {}

    /// Samples of each pixel in the next pass; 0 when the render has ended. Few, so that an interrupted picture is whole, if noisier; of many one at
    /// first, so that there is a whole picture soon; but more where the whole picture is in every batch anyway.
    uint next_pass() const;
    /// The first batch, for which kernels are compiled, has ended so many seconds after the beginning: from here the time of the rules counts.
    void start_clock(double seconds) { start_ = seconds; }
    /// After a pass of so many samples, when the render has taken so many seconds; `noise` as known: one that is not finite is not.
    void end_pass(uint samples, double seconds, const std::optional<Noise> &noise);
    /// Whether the next decision needs the noise.
    bool needs_noise() const { return rules_.error.has_value(); }
    /// Whether the time is over, in the middle of a pass too.
    bool is_late(double seconds) const { return done_ > 0 && rules_.seconds && seconds - start_ >= *rules_.seconds; }
    bool has_reached_error() const { return rules_.error && noise_ && noise_->high <= *rules_.error; }

    uint samples_done() const { return done_; }  ///< of each pixel, by complete passes
    /// How much of the render is done, from 0 to 1: at least the part of its samples, and more if a rule may end it earlier.
    double part(double of_samples, double seconds) const;
    /// As far as rules say it.
    std::optional<double> seconds_left(double seconds) const;

private:
    /// Of each pixel, that the noise's way so far lets expect until the error is reached.
    std::optional<double> samples_left() const;

    const FilmSettings film_;
    uint batch_;
    StopRules rules_;
    /// What there was after so many samples.
    struct Point {
        uint samples;
        double value;
    };
    uint done_ = 0;
    double start_ = 0;    ///< seconds when the clock started
    double seconds_ = 0;  ///< at the end of the last pass
    std::optional<Noise> noise_;
    std::optional<Point> first_;  ///< seconds of the first pass, in which kernels are compiled
    std::optional<Point> mark_;   ///< noise from which its slope is measured next
    double slope_ = 1;            ///< noise falls with this power of the number of samples
};

}  // namespace brandung
