/// What the list of oracles is made of.
#pragma once
#include <memory>

#include "runtime/selftest/oracle.h"

namespace brandung {

std::unique_ptr<PrimitiveOracle> make_sphere_oracle();
std::unique_ptr<PrimitiveOracle> make_triangle_oracle();
std::unique_ptr<PrimitiveOracle> make_smooth_triangle_oracle();
std::unique_ptr<PrimitiveOracle> make_frustum_oracle();
std::unique_ptr<PrimitiveOracle> make_disk_oracle();

}  // namespace brandung
