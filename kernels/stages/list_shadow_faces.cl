// Which faces filtered shadow rays go through: told when a pixel is inspected. Never part of a render.
#include "kernels/stages/transmission.cl"

/// Of shadow ray rays[i], from a primitive in sources[i] where the scene has instances: counts[i] faces, of which the first `capacity` are written
/// from faces[i * capacity] on.
kernel void list_shadow_faces(SCENE_PARAMS, const global Ray *restrict rays, const global uint *restrict sources, uint count, uint capacity,
                              global uint *restrict counts, global PassedFace *restrict faces) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        FaceList passed = {faces + i * capacity, capacity, 0u, rays[i]};
        transmission_along(scene, rays[i], instance_at(sources, i), &passed);
        counts[i] = passed.count;
    }
}
