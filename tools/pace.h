/// Pace: how fast a render goes, counted from the end of its first batch, in which kernels are compiled.
#pragma once
#include <optional>

#include "runtime/renderer.h"

namespace brandung {

class Pace {
public:
    /// After every batch.
    void add(const RenderProgress &progress) {
        if (first_.samples_done == 0 && progress.samples_done < progress.samples_total) first_ = progress;
        last_ = progress;
    }
    /// Nothing where there were no two batches.
    std::optional<double> samples_per_second() const {
        const double samples = static_cast<double>(last_.samples_done - first_.samples_done), seconds = last_.seconds - first_.seconds;
        return samples > 0 && seconds > 0 ? std::optional(samples / seconds) : std::nullopt;
    }
    /// By the rules of the render, if they say it, else by its pace; nothing where only rules can say it.
    std::optional<double> seconds_left() const {
        if (last_.seconds_left || last_.open_ended) return last_.seconds_left;
        const auto speed = samples_per_second();
        return speed ? std::optional(static_cast<double>(last_.samples_total - last_.samples_done) / *speed) : std::nullopt;
    }

private:
    RenderProgress first_{}, last_{};  ///< `first_` is nothing where the first batch was the last
};

}  // namespace brandung
