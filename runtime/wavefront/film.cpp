#include "runtime/wavefront/film.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

/// A pixel's bytes on the device: its sums, its place in the picture and, if samples are splatted, their weights.
std::size_t bytes_of_pixel(bool splats) { return sizeof(FilmPixel) + sizeof(vec3) + (splats ? sizeof(PixelWeights) : 0); }

/// What a band may take at most.
std::size_t checked_band(const Device &device, const Window &window, bool splats, std::size_t largest_band) {
    const std::size_t pixel_bytes = bytes_of_pixel(splats), memory = device.info().memory;
    if (window.pixels() * pixel_bytes > memory)
        throw Error(fmt::format("a film of {} x {} pixels takes {} MiB, more than '{}' has ({} MiB)", window.width(), window.height(),
                                window.pixels() * pixel_bytes >> 20, device.info().name, memory >> 20));
    return std::min<std::size_t>(largest_band, device.info().largest_allocation);
}

}  // namespace

Film::Film(Device &device, const Window &window, std::size_t largest_band, bool splats)
    : window_(window),
      add_(splats ? Kernel(device, "kernels/stages/add_splats.cl", "add_splats", {})
                  : Kernel(device, "kernels/stages/add_samples.cl", "add_samples", {})),
      develop_(splats ? Kernel(device, "kernels/stages/develop_splats.cl", "develop_splats", {})
                      : Kernel(device, "kernels/stages/develop.cl", "develop", {})),
      picture_(device, std::size_t{window.width()} * Bands<FilmPixel>::rows(window, checked_band(device, window, splats, largest_band))),
      bands_(device, window, checked_band(device, window, splats, largest_band)),
      clamped_(device, 1) {
    clamped_.fill_zero();
}

Film::Film(Device &device, const Window &window, std::size_t largest_band) : Film(device, window, largest_band, false) {}

Film::Film(Device &device, const FilmSettings &settings, std::size_t largest_band) : Film(device, settings.window(), largest_band, splats(settings)) {
    if (!splats(settings)) return;
    const std::size_t rows = bands_.begin()->params.rows;
    splatted_.emplace(Splatted{Bands<PixelWeights>(device, window_, rows * window_.width() * sizeof(PixelWeights)), correlated_pixels(settings)});
}

void Film::clear() {
    bands_.clear();
    if (splatted_) splatted_->weights.clear();
}

void Film::add(const Batch &batch, const Buffer<Sample> &samples, Splats *splats) {
    const double per_pixel = batch.params.samples;
    if (!splatted_) {
        for (Band<FilmPixel> &band : bands_)
            add_(batch.params.pixels, batch.params, band.params, batch.pixels, several(samples, per_pixel), updated(band.pixels), shared(clamped_));
        return;
    }
    splats->cut(batch, samples, clamped_);
    for (std::size_t b = 0; b < bands_.size(); ++b)
        for (const Splat &splat : splats->all())
            add_(batch.params.pixels, batch.params, bands_[b].params, splat, several(splats->weights(), 2 * per_pixel),
                 several(splats->values(), 3 * per_pixel), splats->stride(), batch.pixels, updated(bands_[b].pixels),
                 updated(splatted_->weights[b].pixels));
}

std::vector<vec3> Film::develop() {
    std::vector<vec3> picture;
    picture.reserve(window_.pixels());
    for (std::size_t b = 0; b < bands_.size(); ++b) {
        const Buffer<FilmPixel> &pixels = bands_[b].pixels;
        const std::size_t count = pixels.size();
        if (splatted_) {
            develop_(count, static_cast<uint>(count), pixels, splatted_->weights[b].pixels, picture_);
        } else {
            develop_(count, static_cast<uint>(count), pixels, picture_);
        }
        const std::vector<vec3> rows = picture_.read(0, count);
        picture.insert(picture.end(), rows.begin(), rows.end());
    }
    return picture;
}

std::optional<Noise> Film::noise() const {
    const std::size_t width = window_.width();
    const std::size_t at_once = std::max<std::size_t>((1 << 16) / width, 1) * width;  // pixels that are copied from the device
    NoiseSums sums(width, splatted_ ? splatted_->correlated_pixels : 1);
    for (std::size_t b = 0; b < bands_.size(); ++b) {
        const Buffer<FilmPixel> &pixels = bands_[b].pixels;
        for (std::size_t first = 0; first < pixels.size(); first += at_once) {
            const std::size_t count = std::min(at_once, pixels.size() - first);
            const std::vector<PixelWeights> weights = splatted_ ? splatted_->weights[b].pixels.read(first, count) : std::vector<PixelWeights>();
            sums.add_rows(pixels.read(first, count), weights);
        }
    }
    return sums.noise();
}

}  // namespace brandung
