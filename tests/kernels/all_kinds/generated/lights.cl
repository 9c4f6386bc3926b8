// Every kind, for lint and editors.
#pragma once
#include "kernels/lights/directional.cl"
#include "kernels/lights/emissive_disk.cl"
#include "kernels/lights/emissive_flat.cl"
#include "kernels/lights/emissive_frustum.cl"
#include "kernels/lights/emissive_mesh.cl"
#include "kernels/lights/emissive_sphere.cl"
#include "kernels/lights/environment.cl"
#include "kernels/lights/point.cl"
#include "kernels/lights/spot.cl"
#define FOR_EACH_LIGHT(X)                 \
    X(0, PointLight, point)               \
    X(1, DirectionalLight, directional)   \
    X(2, SpotLight, spot)                 \
    X(3, EmissiveMesh, emissive_mesh)     \
    X(4, EmissiveSphere, emissive_sphere) \
    X(5, EmissiveFrustum, emissive_frustum) X(6, Environment, environment) X(7, EmissiveFlat, emissive_flat) X(8, EmissiveDisk, emissive_disk)
