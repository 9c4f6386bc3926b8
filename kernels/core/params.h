/// Small structs that kernels take by value.
#pragma once
#include "kernels/core/portable.h"

#define PIXEL_CORNER 0u
#define PIXEL_CENTER 1u
#define PIXEL_RANDOM 2u

#define CAMERA_WORDS 17

/// 88 bytes. What rays begin at or near, and what else a kind of camera needs, as its view (kernels/cameras/<kind>.h) says.
typedef struct {
    vec3 position;
    uint width, height;  ///< of the picture [pixels]
    float words[CAMERA_WORDS];
} Camera;

/// When a camera's shutter is open, and how many parts its motion has: none if it is at rest.
typedef struct {
    float open, close;  ///< where in the scene's time
    uint parts;
} ShutterParams;

/// Which samples of which pixels a batch holds: slot = pixel in batch × samples + sample - first_sample.
typedef struct {
    uint pixels, first_sample, samples;
    uint spp;  ///< samples per pixel of the whole render
    uint seed;
    uint position;  ///< PIXEL_...
} BatchParams;

/// Whole rows of the film that lie in one buffer.
typedef struct {
    uint first_row, rows;
    uint first_column, width;  ///< pixels in a row
} FilmBand;

typedef struct {
    uint max_depth;   ///< rays in a chain, the eye ray being 1
    float threshold;  ///< rays of smaller weight are not spawned
} WhittedParams;

#define MAX_BUNDLE 1024u
// In Path.depth of a path that is a part of a bundle, above the number of its next surface: bits of the part's number, and of the count of parts - 1.
#define SURFACE_BITS 10u
#define PART_BITS 10u

/// Rays that one surface sends for each kind of what it does, 1 to MAX_BUNDLE.
typedef struct {
    uint light;                          ///< that ask for light
    uint diffuse, glossy, transmission;  ///< that go on: of a material of several kinds, the most of these
} Bundles;

typedef struct {
    uint max_depth;       ///< surfaces that scatter the light of a path
    uint roulette_depth;  ///< from this surface on, rays go on as likely as their surfaces are bright
    Bundles bundles;      ///< of the surfaces that the eye sees; those of others are of one
} PathParams;
