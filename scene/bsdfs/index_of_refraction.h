/// Indices of refraction that materials may have.
#pragma once
#include <string>

namespace brandung {

class Parameters;

/// Of media, sheets and coats. Kernels work with ratios of two, 1e-4 to 1e4, whose squares weigh light that goes through an interface and losses of
/// rough ones, as small as 1e-6: all stay far within floats, and a coat's internal reflectance still differs from 1.
inline constexpr float min_index = 0.01f, max_index = 100;
/// Of metals, either part. Fresnel's formula has fourth powers.
inline constexpr float max_metal_index = 1e4f;

inline bool is_permitted_index(float index) { return index >= min_index && index <= max_index; }
/// Why one that is not permitted is refused.
std::string why_no_index(float index);

/// The parameter `eta`; 1.5 if absent. Throws SceneError with its place where it is not permitted.
float read_index(const Parameters &parameters);

}  // namespace brandung
