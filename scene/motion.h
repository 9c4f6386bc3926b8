/// Motion: maps that change with time, between keys.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/transform.h"

namespace brandung {

/// Where something is at a time.
struct MotionKey {
    double time;
    AffineMap map;
};

/// When light gets to the film. Scene::shutter is that of all cameras together, and its times from 0 to 1 are the device's.
struct Shutter {
    double open = 0, close = 0;
    bool is_instant() const { return open == close; }
    /// As the device has it.
    float place_of(double time) const { return is_instant() ? 0.0f : static_cast<float>((time - open) / (close - open)); }
    bool operator==(const Shutter &) const = default;
};

/// What a map consists of: sign · rotation · stretch, where stretch is symmetric and positive, then a translation (Shoemake & Duff, Graphics
/// Interface 1992).
struct Decomposition {
    double sign;  ///< -1 of a map that mirrors
    glm::dquat rotation;
    glm::dmat3 stretch;
    glm::dvec3 offset;
};
/// Of a map that is not singular.
Decomposition decomposed(const AffineMap &map);

/// Goes from key to key, and stays where it is before the first and after the last. In between the translation and the stretch change evenly, and the
/// rotation turns evenly the shortest way.
class Motion {
public:
    /// One or more, with times that grow.
    explicit Motion(std::vector<MotionKey> keys);
    /// Why it cannot be, if so: a key's map, or what lies between two, is singular or too large.
    std::optional<std::string> fault() const;
    /// Exactly that of a key at its time, or between two that are the same.
    AffineMap at(double time) const;
    /// The times within the shutter between which it changes smoothly, with the shutter's own.
    std::vector<double> breaks(const Shutter &shutter) const;
    bool is_at_rest(const Shutter &shutter) const;

private:
    std::vector<MotionKey> keys_;
    std::vector<Decomposition> parts_;  ///< of the keys
};

}  // namespace brandung
