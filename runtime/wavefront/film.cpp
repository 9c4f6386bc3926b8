#include "runtime/wavefront/film.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

/// A pixel's bytes on the device: its sums, and its place in the picture.
constexpr std::size_t pixel_bytes = sizeof(FilmPixel) + sizeof(vec3);

/// What a band may take at most.
std::size_t checked_band(const Device &device, const Window &window, std::size_t largest_band) {
    const std::size_t memory = device.info().memory;
    if (window.pixels() * pixel_bytes > memory)
        throw Error(fmt::format("a film of {} x {} pixels takes {} MiB, more than '{}' has ({} MiB)", window.width(), window.height(),
                                window.pixels() * pixel_bytes >> 20, device.info().name, memory >> 20));
    return std::min<std::size_t>(largest_band, device.info().largest_allocation);
}

}  // namespace

Film::Film(Device &device, const Window &window, std::size_t largest_band)
    : window_(window),
      add_samples_(device, "kernels/stages/add_samples.cl", "add_samples", {}),
      develop_(device, "kernels/stages/develop.cl", "develop", {}),
      picture_(device, std::size_t{window.width()} * Bands<FilmPixel>::rows(window, checked_band(device, window, largest_band))),
      bands_(device, window, checked_band(device, window, largest_band)),
      clamped_(device, 1) {
    clamped_.fill_zero();
}

void Film::add(const Batch &batch, const Buffer<Sample> &samples) {
    const Access of_batch = several(samples, batch.params.samples);
    for (Band<FilmPixel> &band : bands_)
        add_samples_(batch.params.pixels, batch.params, band.params, batch.pixels, of_batch, updated(band.pixels), shared(clamped_));
}

std::vector<vec3> Film::develop() {
    std::vector<vec3> picture;
    picture.reserve(window_.pixels());
    for (Band<FilmPixel> &band : bands_) {
        const std::size_t count = band.pixels.size();
        develop_(count, static_cast<uint>(count), band.pixels, picture_);
        const std::vector<vec3> rows = picture_.read(0, count);
        picture.insert(picture.end(), rows.begin(), rows.end());
    }
    return picture;
}

std::optional<Noise> Film::noise() const {
    const std::size_t width = window_.width();
    const std::size_t at_once = std::max<std::size_t>((1 << 16) / width, 1) * width;  // pixels that are copied from the device
    NoiseSums sums(width);
    for (const Band<FilmPixel> &band : bands_)
        for (std::size_t first = 0; first < band.pixels.size(); first += at_once)
            sums.add_rows(band.pixels.read(first, std::min(at_once, band.pixels.size() - first)));
    return sums.noise();
}

}  // namespace brandung
