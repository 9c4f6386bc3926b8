/// Float functions from + - * /, fma, selects and integers alone: the same bits on every device, and flat, so that loops of them become vector code.
/// Errors are measured in units in the last place (ulp) of the true result. Subnormal arguments and results count as any other: do not build with
/// -cl-denorms-are-zero. A NaN argument gives NaN unless said otherwise.
#pragma once
#include "kernels/core/lanes_1.cl"

#define PI 3.141592654f
#define INVERSE_TWO_PI 0.159154943f

/// The least float above x (IEEE 754 nextUp): above -0 lies the least subnormal; infinity stays.
FUNCTION float next_up(float x) {
    const uint bits = as_uint(x) == 0x80000000u ? 0u : as_uint(x), next = bits < 0x80000000u ? bits + 1u : bits - 1u;
    return x < INFINITY ? as_float(next) : x;
}

/// The greatest float below x (IEEE 754 nextDown).
FUNCTION float next_down(float x) { return -next_up(-x); }

/// An unevaluated sum, |low| being at most a few ulp of |high|.
typedef struct {
    float high, low;
} TwoFloats;

/// log2 x within 2^-33.8 of its value, near x = 1 too (all floats tried); x = 0 gives high = -infinity, x < 0 NaN; low is finite.
/// x = 2^e m, sqrt(1/2) <= m < sqrt(2); s = (m - 1) / (m + 1); log2 m = 2 / ln 2 atanh s = s (2 / ln 2 + z w(z)), z = s^2.
/// w: minimax of that sum's relative error (2^-37.5; Remez, each coefficient rounded before the next ones were fitted), its first term in two floats.
FUNCTION TwoFloats logarithm_of_base_two(float x) {
    const int subnormal = x < 0x1p-126f;
    const uint half_root = 0x3f3504f3u, bits = as_uint(subnormal ? x * 0x1p24f : x) - half_root;
    const float e = (float)(((int)bits >> 23) - (subnormal ? 24 : 0)), m = as_float((bits & 0x7fffffu) + half_root);

    const float sum = m + 1.0f, sum_low = m - (sum - 1.0f), inverse = 1.0f / sum;
    const float s = (m - 1.0f) * inverse, s_low = inverse * fma(-s, sum_low, fma(-s, sum, m - 1.0f));
    const float z = s * s, z_low = fma(s + s, s_low, fma(s, s, -z));

    const float w_tail = z * fma(z, fma(z, 3.402802050e-01f, 4.117039144e-01f), 5.770828724e-01f);
    const float w_first = 9.617967010e-01f, w = w_first + w_tail, w_low = w_tail - (w - w_first) - 2.172733460e-08f;
    const float v = z * w, v_low = fma(z, w, -v) + fma(z, w_low, z_low * w);
    const float slope_first = 2.885390043e+00f, slope = slope_first + v, slope_low = v - (slope - slope_first) + (v_low + 3.851926067e-08f);
    const float p = s * slope, p_low = fma(s, slope, -p) + fma(s, slope_low, s_low * slope);

    TwoFloats result = {e + p, p - (e + p - e) + p_low};
    const float end = x == 0.0f ? -INFINITY : x > 0.0f ? x : NAN;
    result.high = x > 0.0f && x < INFINITY ? result.high : end;
    return result;
}

/// 2^(high + low), the sum being exact; 0 and infinity beyond the floats, whatever low is then.
/// Minimax of the relative error for |exponent| <= 1/2 (2^-27.6; Remez, rounded, then improved by steps of some ulp).
FUNCTION float two_to_the(float high, float low) {
    const float round = 0x1.8p23f, rounded = high + round;
    const int n = as_int(rounded) - as_int(round), half_n = n >> 1;
    const float x = high - (float)n + low;
    float t = fma(x, 1.535375486e-04f, 1.339917304e-03f);
    t = fma(x, t, 9.618555196e-03f);
    t = fma(x, t, 5.550343916e-02f);
    t = fma(x, t, 2.402264625e-01f);
    t = fma(x, t, 6.931471825e-01f);
    // Two factors, because 2^n itself may be no float.
    float result = fma(x, t, 1.0f) * as_float((half_n + 127) << 23) * as_float((n - half_n + 127) << 23);
    result = high > 129.0f ? INFINITY : result;
    return high < -151.0f ? 0.0f : result;
}

/// e^x, all x: within 0.92 ulp (all floats tried).
FUNCTION float exponential(float x) {
    const float high = x * 1.442695022e+00f;
    return two_to_the(high, fma(x, 1.925962991e-08f, fma(x, 1.442695022e+00f, -high)));
}

/// ln x: within 0.501 ulp (all floats tried); x = 0 gives -infinity, x < 0 NaN.
FUNCTION float logarithm(float x) {
    // ln 2 is rounded down: infinity times either part has the same sign.
    const TwoFloats l = logarithm_of_base_two(x);
    return fma(l.high, 6.931471229e-01f, fma(l.high, 5.769999048e-08f, l.low * 6.931471229e-01f));
}

/// Angle of (x, y) from the x axis, in [-pi, pi], as C's atan2(y, x): for magnitudes up to 2^126, within 2.25 ulp (10^8 pairs tried); (0, 0) gives
/// 0 or pi. The ratio of the smaller to the larger is brought to |t| <= tan(pi / 8); atan t = t + t z p(z), z = t^2, p minimax (2^-30.4 relative to
/// atan; Remez).
FUNCTION float arctangent(float y, float x) {
    const float a = fabs(x), b = fabs(y), small = minimum(a, b), large = maximum(maximum(a, b), 0x1p-149f);
    const bool upper = small > 0.414213562f * large, steep = b > a, left = as_int(x) < 0;
    const float t = upper ? (small - large) / (small + large) : small / large;
    const float z = t * t;
    float p = fma(z, -6.077990703e-02f, 1.059372697e-01f);
    p = fma(z, p, -1.424352224e-01f);
    p = fma(z, p, 1.999847096e-01f);
    p = fma(z, p, -3.333331518e-01f);
    const float q = fma(t * z, p, t);
    // Multiples of pi / 4 in two floats each.
    const float first = upper ? 0.785398185f + (q - 2.18556941e-08f) : q;
    const float second = steep ? 1.57079637f - (first + 4.37113883e-08f) : first;
    const float third = left ? 3.14159274f - (second + 8.74227766e-08f) : second;
    return copysign(third, y);
}

/// x^y, x >= 0 (-0 is 0), all y: within 0.96 ulp (4.5e8 pairs tried, many with x near 1 or results near the ends); x^0 = 1^y = 1 even with NaN.
FUNCTION float power(float x, float y) {
    const TwoFloats l = logarithm_of_base_two(x);
    const float high = y * l.high, low = fma(y, l.high, -high) + y * l.low;
    return x == 1.0f || y == 0.0f ? 1.0f : two_to_the(high, low);
}

/// erf x for x >= 0, infinity too; `gaussian` is exponential(-x * x): within 4e-7. erf x = 1 - exp(-x^2) q(t), t = 1 / (1 + 0.39 x); q minimax of
/// the whole's error (8.6e-9), q(1) = 1.
FUNCTION float error_function(float x, float gaussian) {
    const float t = 1.0f / fma(0.39f, x, 1.0f);
    float q = fma(t, -2.274573900e-01f, 8.863350800e-01f);
    q = fma(t, q, -6.348592300e-01f);
    q = fma(t, q, 6.491173600e-01f);
    q = fma(t, q, 9.156796000e-02f);
    q = fma(t, q, 2.352962200e-01f);
    return fma(-gaussian, q * t, 1.0f);
}

/// The y whose erf is x, |x| < 1: within 3e-7 of it, relatively. y = x p(w), w = -ln(1 - x^2), with one minimax polynomial in w below 5 and one in
/// its square root beyond (9.4e-8 and 1.04e-7, relatively); this division is that of Giles (GPU Computing Gems 2, 2010).
FUNCTION float inverse_error_function(float x) {
    const float w = -logarithm((1.0f - x) * (1.0f + x)), near = w - 2.5f, far = sqrt(w) - 3.0f;
    float p = fma(near, 2.853499789e-08f, 3.437237093e-07f);
    p = fma(near, p, -3.528864264e-06f);
    p = fma(near, p, -4.396751006e-06f);
    p = fma(near, p, 2.186022203e-04f);
    p = fma(near, p, -1.253707590e-03f);
    p = fma(near, p, -4.177707787e-03f);
    p = fma(near, p, 2.466407262e-01f);
    p = fma(near, p, 1.501409422e+00f);
    float q = fma(far, -1.318641449e-04f, 6.081911749e-05f);
    q = fma(far, q, 1.253328092e-03f);
    q = fma(far, q, -3.633741900e-03f);
    q = fma(far, q, 5.784036860e-03f);
    q = fma(far, q, -7.632647398e-03f);
    q = fma(far, q, 9.432023208e-03f);
    q = fma(far, q, 1.001674617e+00f);
    q = fma(far, q, 2.832977082e+00f);
    return x * (w < 5.0f ? p : q);
}

/// Cosine (x) and sine (y) of `turns` full turns, in [-1/8, 1]: within 8e-8 (2^24 tried). Taylor's series up to an eighth of a turn, whose first
/// omitted term is at most 2.5e-8, in the quarter next to it.
FUNCTION vec2 turn(float turns) {
    const float quarters = 4.0f * turns;
    const int quarter = (int)(quarters + 0.5f);
    const float x = (quarters - (float)quarter) * 1.570796327f, square = x * x;
    const float s =
        fma(x * square, fma(square, fma(square, fma(square, 2.755731922e-06f, -1.984126984e-04f), 8.333333333e-03f), -1.666666667e-01f), x);
    const float c = fma(square, fma(square, fma(square, fma(square, 2.480158730e-05f, -1.388888889e-03f), 4.166666667e-02f), -0.5f), 1.0f);
    const bool odd = (quarter & 1) != 0, negative = (quarter & 2) != 0;
    const float cosine = odd ? -s : c, sine = odd ? c : s;
    vec2 result;
    result.x = negative ? -cosine : cosine, result.y = negative ? -sine : sine;
    return result;
}
