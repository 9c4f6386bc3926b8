// The test of a ray against a box, one lane wide.
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/lane_ray.cl"
#include "kernels/core/major_axis.cl"

typedef struct {
    vec3 low, high;
} TestBox;

kernel void test_boxes(const global TestBox *restrict boxes, const global float *restrict extents, const global Ray *restrict rays, uint count,
                       global uchar *restrict hits) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[i];
        LaneBox box;
        box.low = boxes[i].low, box.high = boxes[i].high;
        Crossing crossing;
        crossing.t = 0.0f, crossing.u = 0.0f, crossing.v = 0.0f, crossing.hit = 1;
        const LaneRay lane = lane_ray(ray.origin, ray.direction, ray.t_max, major_axis(ray.direction), -1, extents[i]);
        hits[i] = within_box(crossing, box, lane).hit != 0;
    }
}
