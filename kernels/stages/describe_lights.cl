// What is told of lights when a pixel is inspected. Never part of a render.
#include "kernels/lights/light.cl"
#include "kernels/stages/describe_lights.h"

/// Of light rows[i] at points[i], for the ray with the branch branches[i], which has hit something in instances[i] where the scene has some.
kernel void describe_lights(SCENE_PARAMS, const global SurfacePoint *restrict points, const global uint *restrict branches,
                            const global uint *restrict instances, const global uint *restrict rows, uint count,
                            global LightDescription *restrict descriptions) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const SurfacePoint surface = points[i];
        const LightSample sample =
            light_sample(scene, SCENE_ARRAY(scene, Light, lights)[rows[i]], surface.origin, branches[i], instance_at(instances, i));
        LightDescription description;
        description.irradiance = sample.irradiance;
        description.cosine = dot3(surface.normal, sample.direction);
        description.refusals = light_refusals(surface, sample);
        descriptions[i] = description;
    }
}
