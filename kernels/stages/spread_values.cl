// Values in the order of a list of rays, to the rays' own places: where some slots have no ray, or the list is in another order.
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"

/// values[live[first + i]] = listed[first + i].
kernel void spread_values(LIVE_PARAMS, const global vec3 *restrict listed, global vec3 *restrict values) {
    FOR_EACH_ITEM_SERIALLY(i, count) { values[live[first + i]] = listed[first + i]; }
}
