// Surfaces that paths have met, as the rays that leave them need to know them.
#pragma once
#include "generated/constants.h"
#include "kernels/bsdfs/scattering.cl"
#include "kernels/core/columns.cl"
#include "kernels/core/frame.cl"
#include "kernels/core/sides.cl"

/// Never stored but in columns. What is said of sides is of that which the path comes from.
typedef struct {
    uint flags;            ///< as of SurfacePoint, and MATERIAL_...
    uint material_flags;   ///< 0 where no integrator asks
    vec3 axis, geometric;  ///< the z axis of the BSDF's frame, and the surface's own normal
    vec3 near, far;        ///< where rays begin on that side, and on the other
    vec3 wo;               ///< in the frame
    float eta;             ///< as of BsdfPoint
} MetSurface;

/// The frame is about the shading normal, or the geometric one where the shading normal faces away from wo.
FUNCTION MetSurface met_surface(const global Material *materials, SurfacePoint at, SurfaceInterface interface, vec3 wo) {
    const Sides sides = sides_of(at, interface);
    MetSurface met;
    met.flags = at.flags, met.material_flags = TRANSMITS || BUNDLES ? materials[at.material].flags : 0u;
    met.axis = where(dot3(sides.normal, wo) > 0.0f, sides.normal, sides.geometric), met.geometric = sides.geometric;
    met.near = sides.near, met.far = sides.far;
    met.wo = to_frame(frame_of(met.axis), wo), met.eta = interface.eta;
    return met;
}

typedef struct {
    uint flags[ITEMS_PER_WORK_ITEM], material_flags[ITEMS_PER_WORK_ITEM];
    Vec3Columns axes, geometric, near, far;
    BsdfColumns points;
} MetColumns;

FUNCTION void store_met(MetColumns *columns, uint c, const global Material *materials, MetSurface met, uint material, Tints tints) {
    columns->flags[c] = met.flags, columns->material_flags[c] = met.material_flags;
    store_column(&columns->axes, c, met.axis), store_column(&columns->geometric, c, met.geometric);
    store_column(&columns->near, c, met.near), store_column(&columns->far, c, met.far);
    columns->points.materials[c] = material, columns->points.etas[c] = met.eta;
    columns->points.kinds[c] = !ONE_BSDF && (met.flags & SURFACE_HIT) != 0u ? 1u << materials[material].kind : 0u;
    store_column(&columns->points.wo, c, met.wo), store_tints(&columns->points.tints, c, tints);
}

FUNCTION MetSurface column_met(const MetColumns *columns, uint c) {
    MetSurface met;
    met.flags = columns->flags[c], met.material_flags = columns->material_flags[c];
    met.axis = column_vec3(&columns->axes, c), met.geometric = column_vec3(&columns->geometric, c);
    met.near = column_vec3(&columns->near, c), met.far = column_vec3(&columns->far, c);
    met.wo = column_vec3(&columns->points.wo, c), met.eta = columns->points.etas[c];
    return met;
}

FUNCTION bool is_there(MetSurface met) { return (met.flags & SURFACE_HIT) != 0u; }
FUNCTION bool transmits(MetSurface met) { return TRANSMITS && (met.material_flags & MATERIAL_TRANSMITS) != 0u; }

/// Whether a direction, whose component along the frame's axis is z, leads to the same side of the surface itself as of the shading normal's plane.
FUNCTION bool on_its_side(MetSurface met, vec3 direction, float z) { return dot3(met.geometric, direction) * z > 0.0f; }

/// Whether light may come from there. Where shading normals reflect towards the wrong side of a face, the smooth surface decides, from which the ray
/// begins: if it is not lifted enough to pass its own face, it meets that.
FUNCTION bool may_come_from(MetSurface met, vec3 direction, float z) {
    return (SHADING_NORMALS && !transmits(met) && z > 0.0f) || on_its_side(met, direction, z);
}

/// What a ray in such a direction leaves, and so cannot meet.
FUNCTION uint source_of(MetSurface met, vec3 direction, float z) {
    return !SHADING_NORMALS || on_its_side(met, direction, z) ? SURFACE_PRIMITIVE(met.flags) : NO_HIT;
}
