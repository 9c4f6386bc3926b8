/// The lists of shapes that scene files may name and of kinds of primitives.
#include "scene/primitives/kinds.h"

namespace brandung {

const std::vector<ShapeReader> &shape_readers() {
    static const std::vector<ShapeReader> readers = {
        {"sphere", read_sphere},
        {"disk", read_disk},
        {"frustum", read_frustum},
        {"cylinder", read_cylinder},
        {"triangle_mesh", read_triangle_mesh},
        {"polygon", read_polygon},
        {"mesh", read_mesh, true},
    };
    return readers;
}

const std::vector<const PrimitiveKind *> &primitive_kinds() {
    static const std::vector<const PrimitiveKind *> kinds = {&sphere_kind, &triangle_kind, &smooth_triangle_kind, &frustum_kind, &disk_kind};
    return kinds;
}

}  // namespace brandung
