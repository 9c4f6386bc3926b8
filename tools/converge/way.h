/// Way: how pictures are rendered, as far as it decides what they converge to.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace brandung {

struct Way {
    std::string name;
    std::map<std::string, std::string> settings;   ///< as settings_of(), and the scene's fingerprint as "scene_hash"
    std::map<std::string, std::string> biased_by;  ///< what had an effect beyond noise so far -> why, as Integrator::biases()
    bool transmits = true;                         ///< whether something is transparent, so that shadows differ, or that is not known
};

/// A setting by which two ways do not converge to the same picture.
struct Departure {
    std::string setting, own, other;
};
/// Settings that only change noise do not count, nor limits that had no effect in either.
std::vector<Departure> departures(const Way &way, const Way &other);

/// The pixels of a way, "0,0,16,16 of 64 x 64": left, top, right and bottom in the whole picture; nothing where they are not known.
std::optional<std::string> part_of(const Way &way);

}  // namespace brandung
