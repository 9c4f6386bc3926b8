#include "scene/bsdfs/metals.h"

namespace brandung {

/// Gold, silver and copper: Johnson & Christy, Phys. Rev. B 6, 4370 (1972); aluminium: Rakić, Appl. Opt. 34, 4755 (1995); the others: Johnson &
/// Christy, Phys. Rev. B 9, 5056 (1974). At 611, 549 and 464 nm, the dominant wavelengths of Rec. 709's primaries, linearly between their tables'
/// rows.
const std::vector<Metal> &metals() {
    static const std::vector<Metal> all = {
        {"gold", {0.223f, 0.428f, 1.335f}, {3.204f, 2.460f, 1.872f}},   {"silver", {0.058f, 0.060f, 0.046f}, {4.103f, 3.589f, 2.792f}},
        {"copper", {0.367f, 1.016f, 1.246f}, {3.121f, 2.579f, 2.452f}}, {"aluminium", {1.320f, 1.011f, 0.683f}, {7.307f, 6.616f, 5.623f}},
        {"iron", {2.890f, 2.950f, 2.642f}, {3.040f, 2.930f, 2.803f}},   {"chromium", {3.179f, 3.180f, 2.447f}, {3.300f, 3.330f, 3.205f}},
        {"nickel", {1.985f, 1.920f, 1.763f}, {3.982f, 3.610f, 3.041f}}, {"titanium", {2.658f, 2.540f, 2.303f}, {3.696f, 3.430f, 3.079f}},
    };
    return all;
}

}  // namespace brandung
