// Rays of a pinhole camera, in the precision in force: camera i at picture point i.
#include "generated/precision.cl"
#include "kernels/cameras/perspective.cl"

kernel void test_camera_rays(const global Camera *restrict cameras, const global vec2 *restrict points, uint count,
                             global vec3 *restrict directions) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        directions[i] = camera_ray(cameras[i].position, camera_view(cameras[i]), points[i].x, points[i].y, points[i]).direction;
    }
}
