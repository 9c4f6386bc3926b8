/// How tests make primitives of every kind. A kind that is missing from the table fails the tests that go through all kinds.
#pragma once
#include "tests/support/scenes.h"

namespace brandung {

/// Adds one primitive within `size` of `place`, in each direction, or little more.
using AddPrimitive = void (*)(Scene &scene, uint material, Random &random, vec3 place, float size);

/// Throws std::out_of_range, with the kind's name, if the table has no such kind.
AddPrimitive maker_of(const std::string &kind);
/// Names of all kinds in primitive_kinds().
std::vector<std::string> names_of_primitive_kinds();

}  // namespace brandung
