/// Faces that rays go straight through, from the device.
#pragma once
#include "runtime/inspection/ray_tree.h"
#include "runtime/wavefront/device_scene.h"

namespace brandung {

/// Sets what rays have passed that met faces which are no interfaces, and what filtered shadow rays go through or are blocked by. Throws Error and
/// BuildError.
void list_faces(Device &device, const DeviceScene &scene, std::vector<TracedRay> &trees);

}  // namespace brandung
