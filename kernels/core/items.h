/// What travels between stages: arrays of plain records, and lists of indices into them.
#pragma once
#include "kernels/core/portable.h"

#define RAY_CAMERA 0u
#define RAY_REFLECTED 1u
#define RAY_REFRACTED 2u
#define RAY_SHADOW 3u
#define RAY_KINDS 4u

/// What a ray is, for the counts, and the number of the primitive that it leaves, NO_HIT for none: if that is flat, the ray cannot meet it again.
#define RAY_TAG(kind, primitive) ((kind) | ((primitive) + 1u) << 2)
#define RAY_KIND(tag) ((tag)&3u)
#define RAY_SOURCE(tag) (((tag) >> 2) - 1u)
#define MAX_PRIMITIVES 0x0fffffffu  ///< whose numbers fit a tag, and SurfacePoint.flags

/// What tracing needs; 32 bytes. It begins at t = 0 and ends at t_max. The direction has unit length in the world, but no formula assumes so.
typedef struct {
    vec3 origin;
    float t_max;
    vec3 direction;
    uint tag;  ///< RAY_TAG
} Ray;

#define NO_HIT 0xffffffffu

/// The closest hit of a ray; 16 bytes. `primitive` numbers all primitives in scene order, or is NO_HIT; u, v are the kind's own parameters.
typedef struct {
    float t;
    float u, v;
    uint primitive;
} Hit;

/// State of a ray between eye and lights; 24 bytes.
typedef struct {
    Spectrum throughput;  ///< what its radiance counts in its sample
    uint slot;            ///< its sample: an entry of the running batch
    uint branch;          ///< hash of the way from the eye to here, for random numbers
    uint depth;           ///< 1 for rays from the eye; of bundles see kernels/integrators/bundle.cl
} Path;

#define SURFACE_HIT 1u         ///< the ray hit something
#define SURFACE_LIT 2u         ///< light from lights can be seen on it
#define SURFACE_LIT_BEYOND 4u  ///< and falls on the side away from `wo`: a transparent object's outside, seen from inside
#define SURFACE_BACK 8u        ///< the ray met the side that the geometric normal leads away from
#define SURFACE_PRIMITIVE(flags) ((flags) >> 4)

// A surface point is three records, so that each stage reads whole ones: the compiler reads consecutive records by shuffles, but where the first or
// the last word of one is not used it takes gathers, or computes the last 16 items of every chunk one by one, which halves a stage's speed.

/// Where a ray met the scene, as lights see it; 32 bytes.
typedef struct {
    vec3 origin;  ///< of rays to the lights: the point moved off the surface by its error bound, to the side where light falls
    uint material;
    vec3 normal;  ///< shading normal on that side, unit length
    uint flags;   ///< SURFACE_..., and above these the primitive's number
} SurfacePoint;

/// What else secondary rays need; 28 bytes.
typedef struct {
    vec3 geometric;  ///< geometric normal on the side where light falls, unit length
    float eta;       ///< index of refraction on the side of `wo` over that beyond
    vec3 beyond;     ///< the point moved off to the other side
} SurfaceInterface;

/// By what textures and vertices' colours multiply the reflectances at a hit; after a miss, `diffuse` multiplies the background; 24 bytes.
typedef struct {
    Spectrum diffuse, specular;
} Tints;

/// Rays and hits that the work-items of one number of all launches of tracing stages have seen, by kind of ray.
typedef struct {
    uint64 rays[RAY_KINDS], hits[RAY_KINDS];
} Tally;

/// low + 2^64 high, in two's complement.
typedef struct {
    uint64 low, high;
} Integer128;

/// Radiance of one sample in fixed point: unit 2^-32.
typedef struct {
    Integer128 sum[3];
} Sample;

/// A pixel's exact sums. Those of the samples of even and of odd number are apart: two independent estimates. Squares are in units of 2^-64.
typedef struct {
    Integer128 sums[2][3], squares[2][3];
    uint counts[2];
} FilmPixel;

/// Where samples count in several pixels, FilmPixel has their values and squares times their weights, and counts the pixel's own samples; here are
/// the sums of the weights and of their squares, in units of 2^-30.
typedef struct {
    uint64 sums[2], squares[2];
} PixelWeights;

/// A pixel's sums of values in fixed point, and of the weights of samples that have one, in units of 2^-30.
typedef struct {
    int64 sums[3];
    uint64 weights;
} AovPixel;
