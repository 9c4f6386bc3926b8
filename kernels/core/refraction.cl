// Snell's and Fresnel's laws at a smooth interface.
#pragma once
#include "kernels/core/lanes_1.cl"

/// Squared cosine of the refracted ray; negative where there is total internal reflection. `eta`: index on this side over that beyond.
/// Factored, so that grazing angles keep their digits; every decision about the interface is made by this one value.
FUNCTION float refracted_cosine_squared(float cosine, float eta) { return 1.0f - eta * eta * (1.0f - cosine) * (1.0f + cosine); }

/// Fresnel's reflectance of unpolarised light; 1 for total internal reflection. The mean of the s- and p-polarised ones.
FUNCTION float fresnel(float cosine, float cosine_squared_beyond, float eta) {
    const float beyond = sqrt(maximum(cosine_squared_beyond, 0.0f));
    const float s = (eta * cosine - beyond) / maximum(eta * cosine + beyond, 0x1p-126f);  // 0 / 0 at cosine 0 between equal media
    const float p = (cosine - eta * beyond) / maximum(cosine + eta * beyond, 0x1p-126f);
    return cosine_squared_beyond < 0.0f ? 1.0f : 0.5f * (s * s + p * p);
}

/// Direction beyond an interface of unit normal `normal`, on the side of the unit vector w, of light that goes along w on this side; `cosine` is that
/// of w and the normal.
FUNCTION vec3 refracted(vec3 w, vec3 normal, float cosine, float cosine_squared_beyond, float eta) {
    return minus(scaled(normal, eta * cosine - sqrt(maximum(cosine_squared_beyond, 0.0f))), scaled(w, eta));
}
