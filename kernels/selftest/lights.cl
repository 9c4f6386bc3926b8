// Light from lights of all kinds: light i at point i, for rays of branch i.
#include "kernels/lights/light.cl"

kernel void test_lights(SCENE_PARAMS, const global Light *restrict lights, const global vec3 *restrict points, const global uint *restrict branches,
                        uint count, global LightSample *restrict samples) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) { samples[i] = light_sample(scene, lights[i], points[i], branches[i], PLACEMENT(0u, 0.0f)); }
}
