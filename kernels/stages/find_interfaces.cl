// Moves rays to the interfaces that they meet. Only in scenes with transparent materials.
#include "kernels/core/tally.cl"
#include "kernels/stages/interfaces.cl"

/// An interface is one where the medium that counts changes; a ray passes all others straight on, so that hits[i], and rays[k] for its item k,
/// become those at the interface, with sources[k] and instances[i] as intersect has them, interiors[k] the media before it and beyond[i] those
/// behind. etas[i] is the index of refraction before it over that behind; at an opaque surface, over the material's. Rays passed on are counted with
/// refracted ones, added to a tally per work-item.
kernel void find_interfaces(SCENE_PARAMS, LIVE_PARAMS, global Ray *restrict rays, global uint *restrict sources, global Hit *restrict hits,
                            global uint *restrict instances, const global uchar *restrict crowded, global uint *restrict interiors,
                            global uint *restrict beyond, global float *restrict etas, volatile global uint *restrict lost,
                            global Tally *restrict tallies) {
    const Scene scene = SCENE;
    Tally tally = {{0ul}, {0ul}};
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const uint k = live[first + i];
        const Interior inside = interior_load(interiors, k);
        const PlacedHit met = placed(hits[i], instance_at(instances, i));
        if (met.hit.primitive == NO_HIT || (crowded[i] == 0 && !transmits(scene, met))) {  // most rays are at their end
            interior_store(beyond, i, inside);
            etas[i] = eta_before(scene, inside, met);
            continue;
        }
        Passage passage = passage_of(rays[k], instance_at(sources, k), met, crowded[i] != 0, inside);
        cross_to_interface(scene, &passage, lost, &tally, 0);
        rays[k] = passage.ray;
        hits[i] = passage.met.hit;
        store_instance(sources, k, passage.source), store_instance(instances, i, place_of(passage.met));
        interior_store(interiors, k, passage.inside);
        interior_store(beyond, i, passage.behind);
        etas[i] = passage.eta;
    }
    add_tally(tallies + get_global_id(0), tally);
}
