// Emissive disk: points uniform by area.
#pragma once
#include "kernels/core/frame.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/warp.cl"
#include "kernels/lights/emission.cl"
#include "kernels/lights/stratum.cl"

FUNCTION EmissiveDisk emissive_disk_view(Light l) {
    EmissiveDisk light;
    light.emission = emission_view(l);
    light.center = make3(as_float(l.words[7]), as_float(l.words[8]), as_float(l.words[9]));
    light.normal = make3(as_float(l.words[10]), as_float(l.words[11]), as_float(l.words[12]));
    light.radius = as_float(l.words[13]);
    return light;
}

/// With u = 2^-24 the point is off the plane by at most 2 u of the centre, and 12 u of the radius by the frame's own rounding.
FUNCTION LightSample emissive_disk_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    const EmissiveDisk light = emissive_disk_view(l);
    const vec2 place = concentric_disk(stratum_point(light.emission.stratum, random));
    const vec3 x = from_frame(frame_of(light.normal), make3(place.x * light.radius, place.y * light.radius, 0.0f));
    const float error = 0x1p-20f * (largest(absolute(light.center)) + light.radius);
    return emission_sample(scene, light.emission, PLACE_OF_LIGHT(light.emission, random), p,
                           emissive_point(plus(light.center, x), light.normal, error, 1.0f));
}
