#include "tests/support/statistics/blocks.h"

#include <algorithm>

#include "tests/support/rendering.h"

namespace brandung::statistics {
namespace {

Estimate estimate_of_pixel(const FilmPixel &pixel, std::size_t c) {
    const double sum = static_cast<double>(sum_of(pixel, c)) * 0x1p-32, squares = static_cast<double>(squares_of(pixel, c)) * 0x1p-64;
    return estimate_of(sum, squares, pixel.counts[0] + pixel.counts[1]);
}

}  // namespace

std::vector<Estimate> estimates_of_blocks(const std::vector<FilmPixel> &film, std::size_t width, Block block, std::size_t c) {
    const std::size_t height = film.size() / width;
    std::vector<Estimate> blocks;
    for (std::size_t top = 0; top < height; top += block.height)
        for (std::size_t left = 0; left < width; left += block.width) {
            std::vector<Estimate> pixels;
            for (std::size_t y = top; y < std::min(top + block.height, height); ++y)
                for (std::size_t x = left; x < std::min(left + block.width, width); ++x) pixels.push_back(estimate_of_pixel(film[y * width + x], c));
            blocks.push_back(mean_of(pixels));
        }
    return blocks;
}

std::vector<double> p_of_differences(const std::vector<Estimate> &a, const std::vector<Estimate> &b) {
    std::vector<double> p_values;
    for (std::size_t i = 0; i < a.size(); ++i) p_values.push_back(p_of_difference(a[i], b.at(i)));
    return p_values;
}

}  // namespace brandung::statistics
