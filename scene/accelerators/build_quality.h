/// How much time the build of an accelerator takes for what rays save by it.
#pragma once
#include <array>
#include <cstddef>

namespace brandung {

/// Only accelerators that say so know the difference; no hit does.
enum class BuildQuality { fast, high };
/// In scene files and options, in the order of the values.
inline constexpr std::array build_quality_names = {"fast", "high"};

constexpr const char *name_of(BuildQuality quality) { return build_quality_names[static_cast<std::size_t>(quality)]; }

}  // namespace brandung
