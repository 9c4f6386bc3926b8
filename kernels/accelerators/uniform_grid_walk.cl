// The cells of a uniform grid along a ray: the incremental traversal of Amanatides and Woo (A Fast Voxel Traversal Algorithm for Ray Tracing,
// Eurographics 1987), for rays as thick as rounding makes them.
//
// As there, each axis has the t of the next plane, and the least of the three says which axis steps. But a plane is passed over a little while: the
// next column of cells is entered before the last one is left, by the pad of the boxes' test (lane_ray.cl). So the ray is in a range of columns along
// each axis, nearly always of one. It comes to cells only where it enters a column: then to all cells of that column which lie in the ranges of the
// other two axes, so to each cell once. In a plane of the grid, along an edge or through a corner these are all that touch there.
#pragma once
#include "kernels/accelerators/uniform_grid.h"
#include "kernels/core/rays.cl"

/// Columns are counted along the ray, from 0 to count - 1.
typedef struct {
    float low, size, inverse;
    float near, far;  ///< shifts of planes that are entered, that are left
    int count;
    bool backward;    ///< the ray comes to the highest cells first
    int first, last;  ///< columns that the ray is in
    float next;       ///< t where it enters column last + 1, infinite behind the grid
    float end;        ///< t where it leaves column `first`
    int begin, at;    ///< among the cells that it has come to: where they begin, and where the walk is
} GridAxis;

typedef struct {
    GridAxis x, y, z;
    const global uint *cells;
    float end;      ///< t where the ray leaves the grid
    bool is_begun;  ///< whether the cells at hand are to be gone through
} CellWalk;

/// t of plane `along` as counted along the ray.
FUNCTION float plane_t(const GridAxis *axis, int along, float shift) {
    const int plane = axis->backward ? axis->count - along : along;
    return fma(axis->low + (float)plane * axis->size, axis->inverse, shift);
}
FUNCTION float column_enter(const GridAxis *axis, int column) { return plane_t(axis, column, axis->near); }
FUNCTION float column_leave(const GridAxis *axis, int column) { return plane_t(axis, column + 1, axis->far); }

FUNCTION GridAxis grid_axis(float low, float size, uint count, float inverse, float shift_low, float shift_high) {
    GridAxis axis;
    axis.low = low, axis.size = size, axis.count = (int)count, axis.inverse = inverse;
    axis.backward = inverse < 0.0f;
    axis.near = axis.backward ? shift_high : shift_low, axis.far = axis.backward ? shift_low : shift_high;
    return axis;
}

/// The columns that the ray is in at t, where it is at p: from a guess to what their planes say.
FUNCTION void columns_at(GridAxis *axis, float t, float p) {
    const int last = axis->count - 1;
    const float guess = (p - axis->low) / axis->size, column = axis->backward ? (float)last - floor(guess) : floor(guess);
    int k = (int)minimum(maximum(column, 0.0f), (float)last);
    while (k < last && t >= column_enter(axis, k + 1)) ++k;
    while (k > 0 && t < column_enter(axis, k)) --k;
    axis->last = k;
    while (k > 0 && t <= column_leave(axis, k - 1)) --k;
    axis->first = k;
    axis->next = axis->last < last ? column_enter(axis, axis->last + 1) : INFINITY;
    axis->end = column_leave(axis, axis->first);
}

/// Leaves the columns that lie behind the ray at t.
FUNCTION void leave_columns(GridAxis *axis, float t) {
    while (axis->end < t) axis->end = column_leave(axis, ++axis->first);
}

/// The cells to go through: those of columns begin .. last.
FUNCTION void go_through(CellWalk *walk, int x, int y, int z) {
    walk->x.begin = walk->x.at = x, walk->y.begin = walk->y.at = y, walk->z.begin = walk->z.at = z;
}

FUNCTION void cell_walk_begin(CellWalk *walk, const global CellSpans *spans, const ray_x8 *ray) {
    const global UniformGrid *grid = (const global UniformGrid *)spans;
    walk->cells = (const global uint *)spans + spans->cells;
#define AXIS(x, i) grid_axis(grid->low.x, grid->size.x, grid->columns[i], ray->inverse.x.s0, ray->shift_low.x.s0, ray->shift_high.x.s0)
    walk->x = AXIS(x, 0), walk->y = AXIS(y, 1), walk->z = AXIS(z, 2);
#undef AXIS
    const float t = maximum(maximum(column_enter(&walk->x, 0), column_enter(&walk->y, 0)), maximum(column_enter(&walk->z, 0), 0.0f));
#define END(x) column_leave(&walk->x, walk->x.count - 1)
    walk->end = minimum(minimum(END(x), END(y)), END(z));
#undef END
    walk->is_begun = t <= minimum(walk->end, ray->t_max.s0);
    if (!walk->is_begun) {
        walk->end = -1.0f;
        walk->x.next = walk->y.next = walk->z.next = INFINITY;
        return;
    }
    columns_at(&walk->x, t, fma(t, ray->direction.x.s0, ray->origin.x.s0));
    columns_at(&walk->y, t, fma(t, ray->direction.y.s0, ray->origin.y.s0));
    columns_at(&walk->z, t, fma(t, ray->direction.z.s0, ray->origin.z.s0));
    go_through(walk, walk->x.first, walk->y.first, walk->z.first);
}

/// Enters the next column of some axis. False: the ray ends before it does.
FUNCTION bool enter_column(CellWalk *walk, float t_max) {
    GridAxis *x = &walk->x, *y = &walk->y, *z = &walk->z;
    const float t = minimum(minimum(x->next, y->next), z->next);
    if (!(t <= minimum(walk->end, t_max))) return false;
#define STEP(a, b, c, begin_x, begin_y, begin_z)                                \
    ++a->last;                                                                  \
    a->next = a->last + 1 < a->count ? column_enter(a, a->last + 1) : INFINITY; \
    leave_columns(b, t), leave_columns(c, t);                                   \
    go_through(walk, begin_x, begin_y, begin_z)
    if (t == x->next) {
        STEP(x, y, z, x->last, y->first, z->first);
    } else if (t == y->next) {
        STEP(y, x, z, x->first, y->last, z->first);
    } else {
        STEP(z, x, y, x->first, y->first, z->last);
    }
#undef STEP
    walk->is_begun = true;
    return true;
}

FUNCTION uint cell_number(const GridAxis *x, const GridAxis *y, const GridAxis *z) {
#define INDEX(axis) (uint)(axis->backward ? axis->count - 1 - axis->at : axis->at)
    return (INDEX(z) * (uint)y->count + INDEX(y)) * (uint)x->count + INDEX(x);
#undef INDEX
}

FUNCTION uint cell_walk_next(CellWalk *walk, const ray_x8 *ray) {
    GridAxis *x = &walk->x, *y = &walk->y, *z = &walk->z;
    for (;;) {
        if (!walk->is_begun && !enter_column(walk, ray->t_max.s0)) return NO_ITEMS;
        const uint items = walk->cells[cell_number(x, y, z)];
        COUNT(ray, steps, 1u), COUNT(ray, cells, 1u), COUNT(ray, empty_cells, items == NO_ITEMS);
        walk->is_begun = ++x->at <= x->last || (x->at = x->begin, ++y->at <= y->last) || (y->at = y->begin, ++z->at <= z->last);
        if (items != NO_ITEMS) return items;
    }
}
