/// Emissive shapes as lights: each record is one stratum of one shape, from which every surface point takes one point.
#pragma once
#include "kernels/core/portable.h"

#define MAX_LIGHT_SAMPLES 64u

/// A cell of the k x k into which the unit square is divided from which points of a light are made.
typedef struct {
    uint salt;  ///< of its random numbers, different for every cell of every light
    uint cell;  ///< column | row << 8 | k << 16
} Stratum;

/// What their views of Light.words begin with.
typedef struct {
    Spectrum power;  ///< radiance, times the area where points are uniform by area, over k²
    Stratum stratum;
    uint instance;  ///< that the shape is in; 0: none
    uint dark;      ///< sides that do not shine: MATERIAL_DARK_...
} Emission;

/// A point of a shape's surface, in the shape's own space or in the world; never stored.
typedef struct {
    vec3 p, normal;         ///< of unit length, to the outside
    float error;            ///< bounds how far from the surface p is
    float inverse_density;  ///< over the density with which p was chosen, but for what Emission.power has of it already [area]
} EmissivePoint;

/// Parts of flat faces of a mesh; points are uniform by area. Its stratum has but a salt.
typedef struct {
    Emission emission;
    uint first_face, faces;  ///< in SceneHeader.emissive_faces
} EmissiveMesh;

typedef struct {
    Emission emission;
    vec3 center;
    float radius;
} EmissiveSphere;

/// Points center + z along + x, x ⊥ along, with |z| <= 1 and |x| = radius + rise z; uniform by area.
typedef struct {
    Emission emission;
    vec3 center, along;
    float radius, rise;
} EmissiveFrustum;

/// Points center + x, x ⊥ normal, with |x| <= radius; uniform by area.
typedef struct {
    Emission emission;
    vec3 center, normal;  ///< normal has unit length
    float radius;
} EmissiveDisk;

/// A triangle or parallelogram of a mesh, as a light of its own for paths, which choose among faces as among lights; uniform by area.
typedef struct {
    Spectrum power;     ///< radiance times area
    uint folded;        ///< 1 for a triangle, else 0
    vec3 corner, u, v;  ///< as of EmissiveFace
    uint instance, dark;
} EmissiveFlat;

/// A part of a triangle or parallelogram of a mesh, and its entry in the cell's table of aliases (Walker 1977; Vose 1991). 72 bytes.
typedef struct {
    vec3 corner, u, v;  ///< points corner + s u + t v, s and t in [0, 1]; of a triangle, s + t <= 1 too
    vec3 normal;        ///< unit length, to the outside
    float folded;       ///< 1 for a triangle, else 0
    float error;        ///< bounds how far from the face the points are
    float kept;         ///< with this probability the entry means its own face,
    uint alias;         ///< else this one, counted in the cell
    uint first, last;   ///< the part: s and t are on Morton's curve through the unit square between these places [2^-32]
} EmissiveFace;
