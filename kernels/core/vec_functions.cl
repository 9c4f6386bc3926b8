// Template: vectors of three `real`, and selection, for the lane width in force (core/lanes_*.cl). Included once per width.

FUNCTION real3 make3(real x, real y, real z) {
    real3 v;
    v.x = x, v.y = y, v.z = z;
    return v;
}
FUNCTION real3 plus(real3 a, real3 b) { return make3(a.x + b.x, a.y + b.y, a.z + b.z); }
FUNCTION real3 minus(real3 a, real3 b) { return make3(a.x - b.x, a.y - b.y, a.z - b.z); }
FUNCTION real3 times(real3 a, real3 b) { return make3(a.x * b.x, a.y * b.y, a.z * b.z); }
FUNCTION real3 scaled(real3 a, real s) { return make3(a.x * s, a.y * s, a.z * s); }
FUNCTION real3 negate(real3 a) { return make3(-a.x, -a.y, -a.z); }
FUNCTION real3 absolute(real3 a) { return make3(fabs(a.x), fabs(a.y), fabs(a.z)); }
FUNCTION real dot3(real3 a, real3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }
FUNCTION real3 unit(real3 a) { return scaled(a, 1.0f / sqrt(dot3(a, a))); }

FUNCTION real where(mask m, real a, real b) { return m ? a : b; }
FUNCTION real3 where(mask m, real3 a, real3 b) { return make3(m ? a.x : b.x, m ? a.y : b.y, m ? a.z : b.z); }
FUNCTION real minimum(real a, real b) { return a < b ? a : b; }
FUNCTION real maximum(real a, real b) { return a > b ? a : b; }
FUNCTION real3 minimum(real3 a, real3 b) { return make3(minimum(a.x, b.x), minimum(a.y, b.y), minimum(a.z, b.z)); }
FUNCTION real3 maximum(real3 a, real3 b) { return make3(maximum(a.x, b.x), maximum(a.y, b.y), maximum(a.z, b.z)); }
FUNCTION real largest(real3 a) { return maximum(a.x, maximum(a.y, a.z)); }

/// a b - c d with an error of at most 1.5 ulp, and its exact sign: both products are split without error (Kahan).
FUNCTION real difference_of_products(real a, real b, real c, real d) {
    const real ab = a * b, cd = c * d;
    return (ab - cd) + (fma(a, b, -ab) - fma(c, d, -cd));
}

FUNCTION real3 cross3(real3 a, real3 b) {
    return make3(difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z), difference_of_products(a.x, b.y, a.y, b.x));
}
