#include "runtime/wavefront/film.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

/// A pixel's bytes on the device: its sums, and its place in the picture.
constexpr std::size_t pixel_bytes = sizeof(FilmPixel) + sizeof(vec3);

uint rows_of_band(const Device &device, uint width, uint height, std::size_t largest_band) {
    const std::size_t pixels = std::size_t{width} * height, memory = device.info().memory;
    if (pixels * pixel_bytes > memory)
        throw Error(fmt::format("a film of {} x {} pixels takes {} MiB, more than '{}' has ({} MiB)", width, height, pixels * pixel_bytes >> 20,
                                device.info().name, memory >> 20));
    const std::size_t band = std::min<std::size_t>(largest_band, device.info().largest_allocation);
    return static_cast<uint>(std::clamp<std::size_t>(band / (width * sizeof(FilmPixel)), 1, height));
}

}  // namespace

Film::Film(Device &device, uint width, uint height, std::size_t largest_band)
    : width_(width),
      height_(height),
      add_samples_(device, "kernels/stages/add_samples.cl", "add_samples", {}),
      develop_(device, "kernels/stages/develop.cl", "develop", {}),
      picture_(device, std::size_t{width} * rows_of_band(device, width, height, largest_band)),
      clamped_(device, 1) {
    const uint rows_at_most = rows_of_band(device, width, height, largest_band);
    for (uint row = 0; row < height; row += rows_at_most) {
        const uint rows = std::min(rows_at_most, height - row);
        bands_.push_back({{row, rows, width}, Buffer<FilmPixel>(device, std::size_t{width} * rows)});
        bands_.back().pixels.fill_zero();
    }
    clamped_.fill_zero();
}

void Film::add(const Batch &batch, const Buffer<Sample> &samples) {
    for (Band &band : bands_) add_samples_(batch.params.pixels, batch.params, band.params, batch.pixels, samples, band.pixels, clamped_);
}

std::vector<vec3> Film::develop() {
    std::vector<vec3> picture;
    picture.reserve(std::size_t{width_} * height_);
    for (Band &band : bands_) {
        const std::size_t count = band.pixels.size();
        develop_(count, static_cast<uint>(count), band.pixels, picture_);
        const std::vector<vec3> rows = picture_.read(0, count);
        picture.insert(picture.end(), rows.begin(), rows.end());
    }
    return picture;
}

std::vector<FilmPixel> Film::read() const {
    std::vector<FilmPixel> film;
    for (const Band &band : bands_) {
        const std::vector<FilmPixel> pixels = band.pixels.read();
        film.insert(film.end(), pixels.begin(), pixels.end());
    }
    return film;
}

std::size_t Film::bytes() const {
    std::size_t bytes = picture_.bytes();
    for (const Band &band : bands_) bytes += band.pixels.bytes();
    return bytes;
}

}  // namespace brandung
