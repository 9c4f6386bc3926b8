#include "runtime/schedule.h"

#include <algorithm>
#include <cmath>

#include "scene/filters/filter.h"

namespace brandung {
namespace {

constexpr std::uint64_t few = 16;               ///< samples of a pass
constexpr std::uint64_t enough_for_noise = 4;   ///< samples from which its estimate is worth something
constexpr double flattest = 0.5, steepest = 3;  ///< slopes that noise may have: 1 for independent samples, more for stratified ones

}  // namespace

uint Schedule::next_pass() const {
    if (done_ == film_.spp || has_reached_error()) return 0;
    const std::uint64_t pixels = sampled_window(film_).pixels();
    std::uint64_t pass = done_ == 0 && film_.spp > few ? 1 : few;
    if (rules_.seconds) pass = std::min<std::uint64_t>(pass, std::max(done_, 1u));
    pass = std::max(pass, batch_ / pixels);
    if (rules_.error) {
        // Half of the way, but no more than there is already, so as not to go too far; then small steps. An even number: halves have as many.
        const double wanted = std::clamp<double>(samples_left().value_or(0) / 2, done_ / 16.0, done_);
        const std::uint64_t step = done_ == 0 ? enough_for_noise : 2 * static_cast<std::uint64_t>(std::clamp(wanted / 2, 1.0, 1e6));
        pass = std::min(std::max(pass, enough_for_noise), step);
    }
    return static_cast<uint>(std::min<std::uint64_t>({film_.spp - done_, batch_, pass}));
}

void Schedule::end_pass(uint samples, double seconds, const std::optional<Noise> &noise) {
    done_ += samples, seconds_ = seconds;
    if (!first_) first_ = Point{done_, seconds};
    if (!noise || !std::isfinite(noise->relmse) || !std::isfinite(noise->high) || done_ < enough_for_noise) return;
    noise_ = noise;
    if (noise->relmse == 0 || (mark_ && done_ < 2 * mark_->samples)) return;
    if (mark_) slope_ = std::clamp(std::log(mark_->value / noise->relmse) / std::log(done_ / double(mark_->samples)), flattest, steepest);
    mark_ = Point{done_, noise->relmse};
}

std::optional<double> Schedule::samples_left() const {
    if (!rules_.error || !noise_) return std::nullopt;
    return done_ * std::max(std::pow(noise_->high / *rules_.error, 1 / slope_) - 1, 0.0);
}

double Schedule::part(double of_samples, double seconds) const {
    double part = of_samples;
    if (rules_.seconds) part = std::max(part, (seconds - start_) / *rules_.seconds);
    if (const auto left = samples_left()) part = std::max(part, done_ / (done_ + *left));
    return std::min(part, 1.0);
}

std::optional<double> Schedule::seconds_left(double seconds) const {
    std::optional<double> left;
    if (rules_.seconds) left = std::max(*rules_.seconds - (seconds - start_), 0.0);
    if (const auto samples = samples_left(); samples && done_ > first_->samples) {
        const double predicted = *samples * (seconds_ - first_->value) / (done_ - first_->samples);
        left = left ? std::min(*left, predicted) : predicted;
    }
    return left;
}

}  // namespace brandung
