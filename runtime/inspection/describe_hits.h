/// Descriptions of hits and lights, from the device.
#pragma once
#include "runtime/inspection/ray_tree.h"
#include "runtime/wavefront/device_scene.h"

namespace brandung {

/// Sets the description of every ray that hit something and of every light that was not asked, and what blocks shadow rays that met something,
/// where these are not filtered. Throws Error and BuildError.
void describe_hits(Device &device, const DeviceScene &scene, std::vector<TracedRay> &trees);

}  // namespace brandung
