// Template: on which side of a sphere a point lies, for the lane width in force, as function SPHERE(offset).

/// |p - center|² - radius², right to 2^-42 of |p - center|² + radius².
FUNCTION real SPHERE(offset)(real3 center, real radius, real3 p) {
    const twofold3 f = two_difference(p, center);
    return rounded(plus(dot3(f, f), negate(two_product(radius, radius))));
}
