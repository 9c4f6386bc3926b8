#include "runtime/wavefront/film.h"

namespace brandung {

Film::Film(Device &device, uint width, uint height)
    : width_(width),
      height_(height),
      add_samples_(device, "kernels/stages/add_samples.cl", "add_samples", {}),
      develop_(device, "kernels/stages/develop.cl", "develop", {}),
      pixels_(device, std::size_t{width} * height),
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
