#include "scene/motion.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

/// Polar decomposition by Newton's method (Higham, SIAM J. Sci. Stat. Comput. 7(4) 1986): the nearest orthogonal matrix.
glm::dmat3 nearest_orthogonal(glm::dmat3 m) {
    for (int step = 0; step < 100; ++step) {
        const glm::dmat3 next = 0.5 * (m + glm::transpose(glm::inverse(m)));
        const glm::dmat3 change = next - m;
        m = next;
        if (glm::length(change[0]) + glm::length(change[1]) + glm::length(change[2]) < 1e-15) break;
    }
    return m;
}

AffineMap recomposed(const Decomposition &d) { return {d.sign * glm::mat3_cast(d.rotation) * d.stretch, d.offset}; }

Decomposition between(const Decomposition &a, const Decomposition &b, double f) {
    return {a.sign, glm::slerp(a.rotation, b.rotation, f), a.stretch + f * (b.stretch - a.stretch), a.offset + f * (b.offset - a.offset)};
}

}  // namespace

Decomposition decomposed(const AffineMap &map) {
    const glm::dmat3 orthogonal = nearest_orthogonal(map.linear);
    const double sign = glm::determinant(orthogonal) < 0 ? -1 : 1;
    const glm::dmat3 stretch = glm::transpose(orthogonal) * map.linear;
    return {sign, glm::normalize(glm::quat_cast(sign * orthogonal)), 0.5 * (stretch + glm::transpose(stretch)), map.offset};
}

Motion::Motion(std::vector<MotionKey> keys) : keys_(std::move(keys)) {
    for (const MotionKey &key : keys_) parts_.push_back(make_transforms(key.map) ? decomposed(key.map) : Decomposition{});
}

std::optional<std::string> Motion::fault() const {
    for (std::size_t k = 0; k < keys_.size(); ++k) {
        if (!make_transforms(keys_[k].map))
            return fmt::format("is singular at time {:g}, or it or its inverse has numbers beyond 1e15", keys_[k].time);
        if (k > 0 && parts_[k].sign != parts_[k - 1].sign)
            return fmt::format("becomes singular between times {:g} and {:g}: it mirrors at one of them only", keys_[k - 1].time, keys_[k].time);
    }
    return {};
}

AffineMap Motion::at(double time) const {
    const auto next = std::find_if(keys_.begin(), keys_.end(), [&](const MotionKey &key) { return key.time >= time; });
    if (next == keys_.end()) return keys_.back().map;
    if (next == keys_.begin() || next->time == time) return next->map;
    const auto last = next - 1;
    if (last->map == next->map) return next->map;
    const auto k = static_cast<std::size_t>(next - keys_.begin());
    return recomposed(between(parts_[k - 1], parts_[k], (time - last->time) / (next->time - last->time)));
}

std::vector<double> Motion::breaks(const Shutter &shutter) const {
    std::vector<double> times = {shutter.open};
    for (const MotionKey &key : keys_)
        if (key.time > shutter.open && key.time < shutter.close) times.push_back(key.time);
    times.push_back(shutter.close);
    return times;
}

bool Motion::is_at_rest(const Shutter &shutter) const {
    const AffineMap first = at(shutter.open);
    const std::vector<double> times = breaks(shutter);
    return std::all_of(times.begin(), times.end(), [&](double time) { return at(time) == first; });
}

}  // namespace brandung
