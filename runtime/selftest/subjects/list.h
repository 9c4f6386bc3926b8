/// What the list of subjects is made of: every function adds its own to the end.
#pragma once
#include "runtime/selftest/subject.h"

namespace brandung {

void add_math(std::vector<SubjectEntry> &list);
void add_crossings(std::vector<SubjectEntry> &list);
void add_spawned_rays(std::vector<SubjectEntry> &list);
void add_boxes(std::vector<SubjectEntry> &list);
void add_closed_meshes(std::vector<SubjectEntry> &list);
void add_packets(std::vector<SubjectEntry> &list);
void add_camera_rays(std::vector<SubjectEntry> &list);
void add_instances(std::vector<SubjectEntry> &list);
void add_point_lights(std::vector<SubjectEntry> &list);
void add_emissive_shapes(std::vector<SubjectEntry> &list);
void add_textures(std::vector<SubjectEntry> &list);
void add_vertex_patterns(std::vector<SubjectEntry> &list);
void add_filters(std::vector<SubjectEntry> &list);
void add_panoramas(std::vector<SubjectEntry> &list);
void add_film(std::vector<SubjectEntry> &list);

}  // namespace brandung
