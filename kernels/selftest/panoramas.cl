// Places in panoramas, in the precision in force: direction i, of a panorama that is turned by turns[i].
#include "generated/precision.cl"
#include "kernels/core/items.cl"
#include "kernels/textures/panorama.cl"

kernel void test_panoramas(const global vec3 *restrict directions, const global float *restrict turns, uint count, global vec2 *restrict places) {
    FOR_EACH_ITEM_SERIALLY(i, count) { places[i] = panorama_place(directions[i], turns[i]); }
}
