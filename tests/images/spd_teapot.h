/// The teapot of the Standard Procedural Databases in other sizes.
#pragma once
#include <string>

namespace spd {

/// The scene, in NFF, with patches and board cut into `size` by `size`: what the databases' generator writes for that size. The Bézier patches, which
/// the file does not hold, are those whose points its corners are. `file` is the teapot of size 6. Throws std::runtime_error.
std::string teapot_of_size(const std::string &file, unsigned size);

}  // namespace spd
