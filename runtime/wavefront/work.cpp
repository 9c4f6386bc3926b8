#include "runtime/wavefront/work.h"

namespace brandung {
namespace {

constexpr uint block = 8;

/// Bits 0, 2, 4 of a place on the Z curve of a block.
uint even_bits(uint x) { return (x & 1) | (x >> 1 & 2) | (x >> 2 & 4); }

}  // namespace

std::vector<uint> PixelOrder::next(std::size_t count) {
    const uint width = window_.width(), height = window_.height(), blocks_x = (width + block - 1) / block, blocks_y = (height + block - 1) / block;
    const std::uint64_t places = std::uint64_t{blocks_x} * blocks_y * block * block;
    std::vector<uint> pixels;
    pixels.reserve(count);
    for (; place_ < places && pixels.size() < count; ++place_) {
        const auto b = static_cast<uint>(place_ / (block * block)), within = static_cast<uint>(place_ % (block * block));
        const uint x = b % blocks_x * block + even_bits(within), y = b / blocks_x * block + even_bits(within >> 1);
        if (x < width && y < height) pixels.push_back((window_.left + x) | (window_.top + y) << 16);
    }
    return pixels;
}

}  // namespace brandung
