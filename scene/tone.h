/// From linear values to those that a picture of integers stores, and back.
#pragma once

namespace brandung {

/// IEC 61966-2-1, of fractions of the brightest value.
float srgb_encoded(float linear);
float srgb_decoded(float encoded);

}  // namespace brandung
