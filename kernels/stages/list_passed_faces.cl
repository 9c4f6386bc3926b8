// Which faces rays pass straight on, since they are no interfaces: told when a pixel is inspected. Never part of a render.
#include "kernels/stages/interfaces.cl"

/// Of rays[i] as spawned, from a primitive in sources[i] where the scene has instances, in the media of entry i: counts[i] faces, of which the first
/// `capacity` are written from faces[i * capacity] on.
kernel void list_passed_faces(SCENE_PARAMS, const global Ray *restrict rays, const global uint *restrict sources,
                              const global uint *restrict interiors, uint count, uint capacity, volatile global uint *restrict lost,
                              global uint *restrict counts, global PassedFace *restrict faces) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Nearest nearest = scene_closest_hit(scene, rays[i], instance_at(sources, i));
        Passage passage = passage_of(rays[i], instance_at(sources, i), closest_of(nearest), is_crowded(nearest), interior_load(interiors, i));
        FaceList passed = {faces + i * capacity, capacity, 0u, rays[i]};
        Tally tally = {{0ul}, {0ul}};
        cross_to_interface(scene, &passage, lost, &tally, &passed);
        counts[i] = passed.count;
    }
}
