// Template: numbers of twice the digits, for the lane width in force (core/lanes_*.cl). Included once per width.
// What decides on which side of a surface a ray begins must be right however large the surface is: Dekker, Numer. Math. 18 (1971); Knuth,
// The Art of Computer Programming 2, 4.2.2; Shewchuk, Discrete Comput. Geom. 18 (1997).

/// high + low, where |low| is at most half a unit in the last place of high, or a little more.
typedef struct {
    real high, low;
} twofold;

/// Exact.
FUNCTION twofold two_sum(real a, real b) {
    twofold sum;
    sum.high = a + b;
    const real b_part = sum.high - a;
    sum.low = (a - (sum.high - b_part)) + (b - b_part);
    return sum;
}
FUNCTION twofold two_difference(real a, real b) { return two_sum(a, -b); }
FUNCTION twofold two_product(real a, real b) {
    twofold product;
    product.high = a * b, product.low = fma(a, b, -product.high);
    return product;
}

/// With relative errors of a few 2^-48 of the operands' magnitude.
FUNCTION twofold plus(twofold a, twofold b) {
    twofold sum = two_sum(a.high, b.high);
    sum.low += a.low + b.low;
    return sum;
}
FUNCTION twofold negate(twofold a) {
    a.high = -a.high, a.low = -a.low;
    return a;
}
FUNCTION twofold times(twofold a, twofold b) {
    twofold product = two_product(a.high, b.high);
    product.low += a.high * b.low + a.low * b.high;
    return product;
}
FUNCTION twofold times(twofold a, real b) {
    twofold product = two_product(a.high, b);
    product.low += a.low * b;
    return product;
}
FUNCTION twofold scaled(twofold a, real power_of_two) {
    a.high *= power_of_two, a.low *= power_of_two;
    return a;
}
FUNCTION real rounded(twofold a) { return a.high + a.low; }

/// A power of two s with 1 <= x s < 2, for finite x >= 2^-126; some large one for x = 0.
FUNCTION real binary_reciprocal(real x) { return BITS_REAL(0x7f000000 - (REAL_BITS(x) & 0x7f800000)); }

typedef struct {
    twofold x, y, z;
} twofold3;

FUNCTION twofold3 two_difference(real3 a, real3 b) {
    twofold3 difference;
    difference.x = two_difference(a.x, b.x), difference.y = two_difference(a.y, b.y), difference.z = two_difference(a.z, b.z);
    return difference;
}
FUNCTION real3 high(twofold3 v) { return make3(v.x.high, v.y.high, v.z.high); }
FUNCTION twofold3 scaled(twofold3 v, real power_of_two) {
    v.x = scaled(v.x, power_of_two), v.y = scaled(v.y, power_of_two), v.z = scaled(v.z, power_of_two);
    return v;
}
FUNCTION twofold dot3(twofold3 a, real3 b) { return plus(plus(times(a.x, b.x), times(a.y, b.y)), times(a.z, b.z)); }
FUNCTION twofold two_dot3(real3 a, real3 b) { return plus(plus(two_product(a.x, b.x), two_product(a.y, b.y)), two_product(a.z, b.z)); }
FUNCTION twofold dot3(twofold3 a, twofold3 b) { return plus(plus(times(a.x, b.x), times(a.y, b.y)), times(a.z, b.z)); }
FUNCTION twofold3 cross3(twofold3 a, twofold3 b) {
    twofold3 c;
    c.x = plus(times(a.y, b.z), negate(times(a.z, b.y)));
    c.y = plus(times(a.z, b.x), negate(times(a.x, b.z)));
    c.z = plus(times(a.x, b.y), negate(times(a.y, b.x)));
    return c;
}
