// Rays that are prepared for tracing 16 at once, but then go their own ways: the lanes of what packets are made of, read one by one.
#pragma once
#include "kernels/accelerators/packet.cl"

/// 16 rays, lane by lane. Whoever follows one of them keeps its lane.
typedef struct {
    ray_x16 rays;                   ///< but for the axes
    int16 kx, ky, kz;               ///< axes
    vec3x16 near_shift, far_shift;  ///< as the rays' shifts, of the planes of a box that they meet first and last
    int16 near_x, near_y, near_z;   ///< where 8 boxes' planes that they meet first begin among low x of all, low y, low z, high x, high y, high z
    int16 far_x, far_y, far_z;      ///< and those that they meet last
} PreparedRays;

/// Value of a lane.
#define LANE_OF(column, lane) (((const float *)&(column))[lane])
#define NUMBER_OF(column, lane) (((const int *)&(column))[lane])

FUNCTION float16 axis_of_each(vec3x16 v, int16 axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

FUNCTION vec3x16 turned(vec3x16 v, const PreparedRays *axes) {
    return make3(axis_of_each(v, axes->kx), axis_of_each(v, axes->ky), axis_of_each(v, axes->kz));
}

FUNCTION PreparedRays prepare_each(const Row *row, float extent) {
    PreparedRays prepared;
    const int16 kz = row->axis;
    prepared.kz = kz, prepared.kx = kz == 2 ? (int16)(0) : kz + 1, prepared.ky = kz == 0 ? (int16)(2) : kz - 1;
    ray_x16 rays = lane_ray(row->origin, row->direction, row->t_max, 0u, row->source, extent);
    rays.turned_origin = turned(row->origin, &prepared), rays.shear = shear_of(turned(row->direction, &prepared));
    if (INSTANCES) rays.source_instance = row->source_instance;
    SET_TIME(rays, row->time);
    prepared.rays = rays;
    const int16 x = rays.inverse.x < 0.0f, y = rays.inverse.y < 0.0f, z = rays.inverse.z < 0.0f;
    const vec3x16 low = rays.shift_low, high = rays.shift_high;
    prepared.near_shift = make3(where(x, high.x, low.x), where(y, high.y, low.y), where(z, high.z, low.z));
    prepared.far_shift = make3(where(x, low.x, high.x), where(y, low.y, high.y), where(z, low.z, high.z));
    prepared.near_x = x & 24, prepared.near_y = 8 + (y & 24), prepared.near_z = 16 + (z & 24);
    prepared.far_x = 24 - prepared.near_x, prepared.far_y = 40 - prepared.near_y, prepared.far_z = 56 - prepared.near_z;
    return prepared;
}

/// The rays first .. end - 1 of a list, as row_of_list takes them; at most ITEMS_PER_WORK_ITEM.
FUNCTION void prepare_list(const global Ray *rays, const global uint *live, uint first, uint end, const global uint *source_instances, uint skipped,
                           float extent, PreparedRays *prepared) {
    for (uint i = first; i < end; i += ROW) {
        const Row row = row_of_list(rays, live, i, end, source_instances, skipped);
        *prepared++ = prepare_each(&row, extent);
    }
}

/// Those of `count` numbers, in scenes without instances.
FUNCTION void prepare_numbers(const global Ray *rays, const uint *numbers, uint count, float extent, PreparedRays *prepared) {
    for (uint i = 0u; i < count; i += ROW) {
        uint numbers_here[ROW];
        for (uint j = 0u; j < ROW; ++j) numbers_here[j] = numbers[min(i + j, count - 1u)];
        const Row row = row_of(rays, numbers_here, min(count - i, ROW), 0, 0u);
        *prepared++ = prepare_each(&row, extent);
    }
}

/// The ray of a lane, as prepare() gives it, that ends at t_max.
FUNCTION ray_x8 widened(const PreparedRays *prepared, uint lane, float t_max) {
    const ray_x16 *rays = &prepared->rays;
#define WIDE(column) ((float8)(LANE_OF(rays->column, lane)))
#define WIDE_NUMBER(column) ((int8)(NUMBER_OF(rays->column, lane)))
#define WIDE3(columns) make3(WIDE(columns.x), WIDE(columns.y), WIDE(columns.z))
    ray_x8 wide;
    wide.origin = WIDE3(origin), wide.direction = WIDE3(direction), wide.t_max = (float8)(t_max);
    wide.inverse_square = WIDE(inverse_square);
    wide.source = WIDE_NUMBER(source), wide.source_instance = WIDE_NUMBER(source_instance);
    SET_TIME(wide, LANE_TIME(*rays, lane));
    wide.pad = WIDE(pad);
    wide.inverse = WIDE3(inverse), wide.shift_low = WIDE3(shift_low), wide.shift_high = WIDE3(shift_high);
    wide.turned_origin = WIDE3(turned_origin), wide.shear = WIDE3(shear);
    wide.kx = (uint)NUMBER_OF(prepared->kx, lane), wide.ky = (uint)NUMBER_OF(prepared->ky, lane), wide.kz = (uint)NUMBER_OF(prepared->kz, lane);
#undef WIDE
#undef WIDE_NUMBER
#undef WIDE3
    return wide;
}

/// A ray becomes that of a lane; false if it meets nothing, as lane_ray says. Its components are picked from memory by number, because a processor
/// guesses wrong which is the largest.
FUNCTION bool prepare_lane(Ray ray, int source_instance, float extent, PreparedRays *prepared, uint lane) {
    const uint kz = major_axis(ray.direction), kx = kz == 2u ? 0u : kz + 1u, ky = kz == 0u ? 2u : kz - 1u;
    const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z}, direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    const vec3x8 o = make3((float8)(ray.origin.x), (float8)(ray.origin.y), (float8)(ray.origin.z));
    const vec3x8 d = make3((float8)(ray.direction.x), (float8)(ray.direction.y), (float8)(ray.direction.z));
    const ray_x8 wide = lane_ray(o, d, (float8)(ray.t_max), 0u, (int8)(0), extent);
    const vec3x8 shear = shear_of(make3((float8)(direction[kx]), (float8)(direction[ky]), (float8)(direction[kz])));
    const int8 x = wide.inverse.x < 0.0f, y = wide.inverse.y < 0.0f, z = wide.inverse.z < 0.0f;
    const vec3x8 low = wide.shift_low, high = wide.shift_high;
    ray_x16 *rays = &prepared->rays;
#define STORE(column, value) ((float *)&(column))[lane] = (value)
#define STORE_NUMBER(column, value) ((int *)&(column))[lane] = (int)(value)
#define STORE3(columns, values) STORE(columns.x, (values).x), STORE(columns.y, (values).y), STORE(columns.z, (values).z)
#define STORE3_OF_8(columns, values) STORE(columns.x, (values).x.s0), STORE(columns.y, (values).y.s0), STORE(columns.z, (values).z.s0)
    STORE3(rays->origin, ray.origin), STORE3(rays->direction, ray.direction);
    STORE(rays->inverse_square, wide.inverse_square.s0), STORE(rays->pad, wide.pad.s0);
    STORE_NUMBER(rays->source, RAY_SOURCE(ray.tag)), STORE_NUMBER(rays->source_instance, source_instance);
    STORE3_OF_8(rays->inverse, wide.inverse), STORE3_OF_8(rays->shift_low, low), STORE3_OF_8(rays->shift_high, high);
    STORE(rays->turned_origin.x, origin[kx]), STORE(rays->turned_origin.y, origin[ky]), STORE(rays->turned_origin.z, origin[kz]);
    STORE3_OF_8(rays->shear, shear);
    STORE_NUMBER(prepared->kx, kx), STORE_NUMBER(prepared->ky, ky), STORE_NUMBER(prepared->kz, kz);
    STORE3_OF_8(prepared->near_shift, make3(where(x, high.x, low.x), where(y, high.y, low.y), where(z, high.z, low.z)));
    STORE3_OF_8(prepared->far_shift, make3(where(x, low.x, high.x), where(y, low.y, high.y), where(z, low.z, high.z)));
    STORE_NUMBER(prepared->near_x, x.s0 & 24), STORE_NUMBER(prepared->near_y, 8 + (y.s0 & 24)), STORE_NUMBER(prepared->near_z, 16 + (z.s0 & 24));
    STORE_NUMBER(prepared->far_x, 24 - (x.s0 & 24)), STORE_NUMBER(prepared->far_y, 32 - (y.s0 & 24)), STORE_NUMBER(prepared->far_z, 40 - (z.s0 & 24));
#undef STORE
#undef STORE_NUMBER
#undef STORE3
#undef STORE3_OF_8
    return wide.t_max.s0 >= 0.0f;
}
