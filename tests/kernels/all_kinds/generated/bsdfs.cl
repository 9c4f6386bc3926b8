// Every kind, for lint and editors.
#pragma once
#include "kernels/bsdfs/conductor.cl"
#include "kernels/bsdfs/dielectric.cl"
#include "kernels/bsdfs/diffuse.cl"
#include "kernels/bsdfs/null.cl"
#include "kernels/bsdfs/phong.cl"
#include "kernels/bsdfs/plastic.cl"
#include "kernels/bsdfs/thin_dielectric.cl"
#include "kernels/bsdfs/whitted.cl"
#define FOR_EACH_BSDF(X)       \
    X(0, Whitted, whitted)     \
    X(1, Diffuse, diffuse)     \
    X(2, Conductor, conductor) \
    X(3, Plastic, plastic) X(4, ModifiedPhong, phong) X(5, Dielectric, dielectric) X(6, ThinDielectric, thin_dielectric) X(7, Null, null)
