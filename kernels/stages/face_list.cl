// Lists of the faces that rays go straight through. Inspection has them; stages give 0 in their place, and nothing of them is left.
#pragma once
#include "generated/instances.cl"
#include "kernels/primitives/surface.h"
#include "kernels/stages/face_list.h"

typedef struct {
    global PassedFace *faces;  ///< room for `capacity`
    uint capacity, count;
    Ray ray;  ///< as spawned
} FaceList;

/// Counts all, and keeps those that there is room for.
FUNCTION void face_list_add(FaceList *list, PlacedHit met, vec3 p, bool enters, Spectrum transmission) {
    PassedFace face;
    face.p = p, face.enters = enters;
    face.hit = met.hit, face.hit.t = dot3(minus(p, list->ray.origin), list->ray.direction) / dot3(list->ray.direction, list->ray.direction);
    face.transmission = transmission, face.instance = instance_of(met);
    if (list->count < list->capacity) list->faces[list->count] = face;
    ++list->count;
}
