// Template: on which side of a triangle's plane a point lies, for the lane width in force, as function TRIANGLE(plane_offset).

/// normal · (p - a), where the normal is (b - a) × (c - a), scaled so that the edges' largest component becomes 1 to 2. Right to 2^-42 of the
/// lengths, so its sign is right unless p is that near to the plane.
FUNCTION real TRIANGLE(plane_offset)(real3 a, real3 b, real3 c, real3 p, real3 *normal) {
    const twofold3 e = two_difference(b, a), f = two_difference(c, a), g = two_difference(p, a);
    const real scale = binary_reciprocal(largest(maximum(absolute(high(e)), absolute(high(f)))));
    const twofold3 n = cross3(scaled(e, scale), scaled(f, scale));
    *normal = make3(rounded(n.x), rounded(n.y), rounded(n.z));
    const real near = binary_reciprocal(largest(absolute(high(g))));
    return rounded(dot3(n, scaled(g, near))) / near;
}
