/// What the integrators ask of a BSDF; never stored.
#pragma once
#include "kernels/core/portable.h"

#define INVERSE_PI 0.318309886f

/// How an ideal interface divides the light: weights of the mirrored and of the refracted ray.
typedef struct {
    Spectrum reflected, refracted;
} Split;

/// Phong's model, as Whitted's integrator lights a surface with it.
typedef struct {
    Spectrum diffuse, specular;  ///< reflectances
    float exponent;              ///< of the highlight
} Phong;

// What path tracing asks of a kind `name`, in the frame of the hit: z is the shading normal on the side of `wo`, whose z is above 0.
//   BsdfValue name_eval(const global Material *m, BsdfPoint point, vec3 wi)
//   BsdfSample name_sample(const global Material *m, BsdfPoint point, vec2 u, float choice)
// and for pictures of surfaces without light, about the part of light that is reflected or let through, whatever the angle:
//   Spectrum name_albedo(const global Material *m, Tints tint)

/// A hit as a BSDF sees it; never stored.
typedef struct {
    vec3 wo;                               ///< unit vector back along the ray, z > 0
    float eta;                             ///< index of refraction on the side of wo over that beyond
    Spectrum diffuse_tint, specular_tint;  ///< by which pictures multiply these reflectances
} BsdfPoint;

/// Of light that comes from wi; lobes that are a single direction have no part in it.
typedef struct {
    Spectrum value;  ///< f(wo, wi) |cos of wi|, for radiance [1/sr]; beyond an interface it has the factor eta² of radiance
    float pdf;       ///< with which `sample` chooses wi, in solid angle [1/sr]
} BsdfValue;

typedef struct {
    vec3 wi;          ///< unit vector towards where light comes from; z < 0: through the surface
    Spectrum weight;  ///< f |cos of wi| / pdf, of all lobes; 0 where nothing is to follow
    float pdf;        ///< as that of eval, of all lobes; INFINITY for a lobe that is a single direction, whose weight is its part over its chance
} BsdfSample;
