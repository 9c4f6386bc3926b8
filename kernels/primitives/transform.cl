// Template: transforms of points and directions, for the lane width in force.

FUNCTION real3 transformed_direction(Transform m, real3 d) {
    return make3(fma((real)(m.x.x), d.x, fma((real)(m.y.x), d.y, m.z.x * d.z)), fma((real)(m.x.y), d.x, fma((real)(m.y.y), d.y, m.z.y * d.z)),
                 fma((real)(m.x.z), d.x, fma((real)(m.y.z), d.y, m.z.z * d.z)));
}

FUNCTION real3 transformed_point(Transform m, real3 p) {
    return make3(fma((real)(m.x.x), p.x, fma((real)(m.y.x), p.y, fma((real)(m.z.x), p.z, (real)(m.origin.x)))),
                 fma((real)(m.x.y), p.x, fma((real)(m.y.y), p.y, fma((real)(m.z.y), p.z, (real)(m.origin.y)))),
                 fma((real)(m.x.z), p.x, fma((real)(m.y.z), p.y, fma((real)(m.z.z), p.z, (real)(m.origin.z)))));
}
