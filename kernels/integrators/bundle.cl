// Bundles: at the surface that the eye sees a path goes on as several, and asks for light several times (Cook, Porter & Carpenter, Distributed Ray
// Tracing, SIGGRAPH 1984); from there on each is a path like any other. Without BUNDLES all this is nothing.
#pragma once
#include "generated/constants.h"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/load.cl"
#include "kernels/core/params.h"
#include "kernels/core/scene.h"
#include "kernels/samplers/part.cl"

FUNCTION Part part_of(Path path) {
    if (!BUNDLES) return whole_sample();
    return part(path.depth >> SURFACE_BITS & (MAX_BUNDLE - 1u), (path.depth >> (SURFACE_BITS + PART_BITS)) + 1u);
}

FUNCTION uint depth_word(uint surface_number, Part part) {
    return surface_number | part.number << SURFACE_BITS | (part.count - 1u) << (SURFACE_BITS + PART_BITS);
}

/// Rays that go on from such a material at the first surface.
FUNCTION uint bundle_size(uint material_flags, Bundles sizes) {
    const uint diffuse = (material_flags & MATERIAL_DIFFUSE) != 0u ? sizes.diffuse : 1u;
    const uint glossy = (material_flags & MATERIAL_GLOSSY) != 0u ? sizes.glossy : 1u;
    const uint transmission = (material_flags & MATERIAL_PASSES) != 0u ? sizes.transmission : 1u;
    return max(diffuse, max(glossy, transmission));
}

/// What one row of a launch does for a path at its surface.
typedef struct {
    Part going, asking;  ///< of the rays of either kind that the surface sends
    Part path;           ///< which part of its sample the path is
    uint surface;        ///< the surface's number on the path, from 1 on
} BundleRow;

FUNCTION BundleRow bundle_row(Path path, uint surface, uint row, uint material_flags, Bundles sizes) {
    const bool spreads = BUNDLES && surface == 1u;
    BundleRow result;
    result.going = part(row, spreads ? bundle_size(material_flags, sizes) : 1u);
    result.asking = part(row, spreads ? sizes.light : 1u);
    result.path = part_of(path);
    result.surface = surface;
    return result;
}

FUNCTION float share_of(Part part) { return 1.0f / (float)(int)part.count; }

/// By what the ratio of two densities counts for the rays that go on, over those that ask.
FUNCTION float ratio_of_counts(BundleRow row) { return (float)(int)row.going.count / (float)(int)row.asking.count; }

/// Whether in this row no item of the chunk has anything to send.
FUNCTION bool is_beyond_bundles(const global Material *materials, const global SurfacePoint *points, Chunk chunk, uint row, Bundles sizes) {
    if (row == 0u) return false;
    if (LIGHTS && row < sizes.light) return false;
    for (uint c = 0u; c < chunk.items; ++c) {
        const SurfacePoint at = points[chunk.begin + c];
        if ((at.flags & SURFACE_HIT) != 0u && row < bundle_size(materials[at.material].flags, sizes)) return false;
    }
    return true;
}

/// What items have asked for in so many rows, where it is visible: 0 of none.
FUNCTION void add_asked_light(uint count, uint rows, uint stride, const global uchar *visible, const global Spectrum *light, global Spectrum *sums) {
    const Spectrum black = make3(0.0f, 0.0f, 0.0f);
    if (!LIGHTS || rows == 0u) {
        FOR_EACH_ITEM(i, count) {
            sums[i] = black;
        }
        return;
    }
    {
        FOR_EACH_ITEM(i, count) {
            sums[i] = where(visible[i] != 0, load(light + i), black);
        }
    }
    for (uint row = 1u; BUNDLES && row < rows; ++row) {
        const global Spectrum *row_light = light + row * stride;
        const global uchar *row_visible = visible + row * stride;
        FOR_EACH_ITEM(i, count) {
            sums[i] = plus(sums[i], where(row_visible[i] != 0, load(row_light + i), black));
        }
    }
}
