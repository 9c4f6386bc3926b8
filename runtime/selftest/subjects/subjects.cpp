/// The list of subjects.
#include "runtime/selftest/subjects/list.h"

namespace brandung {

const std::vector<SubjectEntry> &subjects() {
    static const std::vector<SubjectEntry> list = [] {
        std::vector<SubjectEntry> entries;
        for (const auto add : {add_math, add_boxes, add_crossings, add_spawned_rays, add_closed_meshes, add_packets, add_camera_rays, add_instances,
                               add_point_lights, add_emissive_shapes, add_textures, add_vertex_patterns, add_filters, add_panoramas, add_film})
            add(entries);
        return entries;
    }();
    return list;
}

}  // namespace brandung
