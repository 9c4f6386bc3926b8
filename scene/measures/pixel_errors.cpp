#include "scene/measures/pixel_errors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brandung {
namespace {

constexpr double epsilon = 0.01;  ///< keeps errors relative to black finite

/// Sums over some pixels' channels.
struct Sums {
    double squared = 0, relative_squared = 0, relative = 0, peak = 0;
    glm::dvec3 test{0}, reference{0};
    std::size_t pixels = 0;
    MaxError max_error;
};

void add_pixel(Sums &sums, const PicturePair &pair, uint x, uint y) {
    const std::size_t i = std::size_t(y) * pair.width + x;
    if (!pair.finite[i]) return;
    const glm::dvec3 a(pair.test[i]), b(pair.reference[i]);
    for (int c = 0; c < 3; ++c) {
        const double error = std::abs(a[c] - b[c]);
        sums.squared += error * error;
        sums.relative_squared += error * error / (b[c] * b[c] + epsilon);
        sums.relative += error / (std::abs(b[c]) + epsilon);
        sums.peak = std::max({sums.peak, a[c], b[c]});
        if (error > sums.max_error.error) sums.max_error = {x, y, uint(c), error};
    }
    sums.test += a, sums.reference += b;
    ++sums.pixels;
}

bool comes_first(const MaxError &a, const MaxError &b) { return a.error != b.error ? a.error > b.error : std::pair(a.y, a.x) < std::pair(b.y, b.x); }

void add(Sums &sums, const Sums &more) {
    sums.squared += more.squared, sums.relative_squared += more.relative_squared, sums.relative += more.relative;
    sums.peak = std::max(sums.peak, more.peak);
    sums.test += more.test, sums.reference += more.reference;
    sums.pixels += more.pixels;
    if (comes_first(more.max_error, sums.max_error)) sums.max_error = more.max_error;
}

/// relMSE of some pixels; 0 if there are none.
double relmse(const Sums &sums) { return sums.pixels ? sums.relative_squared / double(3 * sums.pixels) : 0; }

/// A block, and its sums.
struct BlockSums {
    ErrorBlock block;
    Sums sums;
};

BlockSums block_sums(const PicturePair &pair, uint x, uint y) {
    BlockSums block{{x, y, std::min(error_block_size, pair.width - x), std::min(error_block_size, pair.height - y)}, {}};
    for (uint j = y; j < y + block.block.height; ++j)
        for (uint i = x; i < x + block.block.width; ++i) add_pixel(block.sums, pair, i, j);
    block.block.relmse = relmse(block.sums);
    return block;
}

/// All blocks, in order of rows.
std::vector<BlockSums> all_blocks(const PicturePair &pair) {
    const uint columns = (pair.width + error_block_size - 1) / error_block_size, rows = (pair.height + error_block_size - 1) / error_block_size;
    std::vector<BlockSums> blocks(std::size_t(columns) * rows);
    tbb::parallel_for(uint(0), rows, [&](uint row) {
        for (uint column = 0; column < columns; ++column)
            blocks[std::size_t(row) * columns + column] = block_sums(pair, column * error_block_size, row * error_block_size);
    });
    return blocks;
}

}  // namespace

PixelErrors pixel_errors(const PicturePair &pair) {
    Sums sums;
    PixelErrors errors{.worst_block = {.relmse = -1}};
    for (const BlockSums &block : all_blocks(pair)) {
        add(sums, block.sums);
        if (block.block.relmse > errors.worst_block.relmse) errors.worst_block = block.block;
    }
    const double pixels = double(sums.pixels);
    errors.mse = sums.squared / (3 * pixels);
    errors.relmse = relmse(sums);
    errors.mape = sums.relative / (3 * pixels);
    errors.peak = pair.range == DynamicRange::hdr ? std::max(1.0, sums.peak) : 1.0;
    errors.psnr = 10 * std::log10(errors.peak * errors.peak / errors.mse);
    errors.max_error = sums.max_error;
    errors.test_mean = sums.test / pixels, errors.reference_mean = sums.reference / pixels;
    return errors;
}

}  // namespace brandung
