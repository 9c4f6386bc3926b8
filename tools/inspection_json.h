/// An inspected pixel as JSON; text is made from the same.
#pragma once
#include <nlohmann/json.hpp>

#include "runtime/inspection/inspect_pixel.h"
#include "scene/compile.h"

namespace brandung {

/// Names are a promise: add, don't rename. Floats are {"decimal": number, "hex": text}, with vectors arrays of three of each; what is not finite
/// has no decimal (null). Fixed point is in units of 2^-32, as decimal text since it may take more than 53 bits.
nlohmann::json inspection_json(const Scene &scene, const CompiledScene &compiled, const InspectedPixel &pixel, uint x, uint y);

}  // namespace brandung
