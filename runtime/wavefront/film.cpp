#include "runtime/wavefront/film.h"

#include <fmt/format.h>

namespace brandung {

namespace {

std::size_t checked_pixels(const Device &device, uint width, uint height) {
    const std::size_t pixels = std::size_t{width} * height;
    if (pixels * sizeof(FilmPixel) > device.info().largest_allocation)
        throw Error(fmt::format("a film of {} x {} pixels takes {} MiB, more than one allocation of '{}' can have ({} MiB)", width, height,
                                pixels * sizeof(FilmPixel) >> 20, device.info().name, device.info().largest_allocation >> 20));
    return pixels;
}

}  // namespace

Film::Film(Device &device, uint width, uint height)
    : width_(width),
      height_(height),
      add_samples_(device, "kernels/stages/add_samples.cl", "add_samples", {}),
      develop_(device, "kernels/stages/develop.cl", "develop", {}),
      pixels_(device, checked_pixels(device, width, height)),
      picture_(device, std::size_t{width} * height),
      clamped_(device, 1) {
    pixels_.fill_zero();
    clamped_.fill_zero();
}

void Film::add(const Batch &batch, const Buffer<Sample> &samples) {
    add_samples_(batch.params.pixels, batch.params, width_, batch.pixels, samples, pixels_, clamped_);
}

std::vector<vec3> Film::develop() {
    develop_(pixels_.size(), static_cast<uint>(pixels_.size()), pixels_, picture_);
    return picture_.read();
}

}  // namespace brandung
