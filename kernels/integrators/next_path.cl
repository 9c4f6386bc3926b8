// Paths that go on from a surface.
#pragma once
#include "kernels/core/random.cl"
#include "kernels/core/spawn.cl"
#include "kernels/integrators/bundle.cl"
#include "kernels/integrators/met_surface.cl"

/// A path behind its next surface.
typedef struct {
    Ray ray;
    Path path;
    float pdf;       ///< of the ray's direction, as of BsdfSample, times the rays that go on for each that asks for light
    float survival;  ///< the chance that it is not ended
    bool enters;     ///< what is behind the surface
    bool lives;
} NextPath;

/// In the direction `next`, unless chance ends it by `u` in [0, 1).
FUNCTION NextPath next_path(MetSurface met, Path path, BundleRow row, BsdfSample next, uint roulette_depth, float u) {
    const bool stays = next.wi.z > 0.0f, single = next.pdf == INFINITY;
    const vec3 scattered = from_frame(frame_of(met.axis), next.wi), outwards = scaled(met.geometric, stays ? 1.0f : -1.0f);
    // The shading normal may lead the only direction of a mirror to the wrong side of the surface: then its mirror image at the surface counts.
    const vec3 wi = unit(SHADING_NORMALS && single ? folded(scattered, outwards) : scattered);
    NextPath child;
    child.enters = !stays && transmits(met);
    // Radiance in a medium of index n has a factor n², which must not count as brightness.
    const float scale = child.enters ? 1.0f / (met.eta * met.eta) : 1.0f;
    child.survival = row.surface >= roulette_depth ? minimum(largest(next.weight) * scale, 1.0f) : 1.0f;
    child.path = path;
    child.path.depth = depth_word(row.surface + 1u, part_within(row.path, row.going));
    child.path.throughput = scaled(times(path.throughput, next.weight), child.survival > 0.0f ? share_of(row.going) / child.survival : 0.0f);
    child.path.branch = hash(path.branch * 2u + row.going.number);
    const vec3 origin = where(stays, met.near, met.far);
    child.ray = ray_spawn(origin, wi, stays ? RAY_REFLECTED : RAY_REFRACTED, source_of(met, wi, next.wi.z));
    child.pdf = next.pdf * ratio_of_counts(row);
    child.lives = is_there(met) && may_come_from(met, wi, next.wi.z) && u < child.survival && largest(child.path.throughput) > 0.0f &&
                  row.going.number < row.going.count;
    return child;
}
