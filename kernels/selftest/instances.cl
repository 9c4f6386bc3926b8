// Instances: rays on their way into a group's space, and surfaces on their way out, one after another: input i is in instance i + 1.
#include "generated/precision.cl"
#include "kernels/core/items.cl"
#include "kernels/primitives/instance.cl"

typedef struct {
    vec3 origin, direction;  ///< of the ray in the group's space
    Surface world;
    vec3 back;  ///< the surface's point in the world, as the origin of a ray, in the group's space
} InstanceResult;

kernel void test_instances(SCENE_PARAMS, const global Ray *restrict rays, const global Surface *restrict surfaces, uint count,
                           global InstanceResult *restrict results) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        Ray ray = ray_in_group(scene, i + 1u, rays[i]);
        InstanceResult result;
        result.origin = ray.origin, result.direction = ray.direction;
        result.world = surface_in_world(scene, i + 1u, surfaces[i]);
        ray.origin = result.world.p;
        result.back = ray_in_group(scene, i + 1u, ray).origin;
        results[i] = result;
    }
}
