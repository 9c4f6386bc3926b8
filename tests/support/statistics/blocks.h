/// Pictures as means of blocks of pixels, with their errors.
#pragma once
#include <vector>

#include "kernels/core/items.h"
#include "tests/support/statistics/means.h"

namespace brandung::statistics {

struct Block {
    std::size_t width, height;  ///< [pixels]
};

/// Of channel c of the blocks of a picture, row by row; blocks at the right and lower edges may be smaller. Every pixel has two samples or more. The
/// samples count as independent: where they are stratified, the errors are smaller than is said here.
std::vector<Estimate> estimates_of_blocks(const std::vector<FilmPixel> &film, std::size_t width, Block block, std::size_t c);

/// Of each block of two pictures, block by block.
std::vector<double> p_of_differences(const std::vector<Estimate> &a, const std::vector<Estimate> &b);

}  // namespace brandung::statistics
