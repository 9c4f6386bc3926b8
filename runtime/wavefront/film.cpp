#include "runtime/wavefront/film.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

/// A pixel's bytes on the device: its sums, and its place in the picture.
constexpr std::size_t plain_bytes = sizeof(FilmPixel) + sizeof(vec3);

/// What a band may take at most.
std::size_t checked_band(const Device &device, const Window &window, std::size_t pixel_bytes, std::size_t largest_band) {
    const std::size_t memory = device.info().memory;
    if (window.pixels() * pixel_bytes > memory)
        throw Error(fmt::format("a film of {} x {} pixels takes {} MiB, more than '{}' has ({} MiB)", window.width(), window.height(),
                                window.pixels() * pixel_bytes >> 20, device.info().name, memory >> 20));
    return std::min<std::size_t>(largest_band, device.info().largest_allocation);
}

}  // namespace

Film::Film(Device &device, const Window &window, std::size_t largest_band, std::size_t pixel_bytes)
    : window_(window),
      add_samples_(device, "kernels/stages/add_samples.cl", "add_samples", {}),
      develop_(device, "kernels/stages/develop.cl", "develop", {}),
      picture_(device, std::size_t{window.width()} * Bands<FilmPixel>::rows(window, checked_band(device, window, pixel_bytes, largest_band))),
      bands_(device, window, checked_band(device, window, pixel_bytes, largest_band)),
      clamped_(device, 1) {
    clamped_.fill_zero();
}

Film::Film(Device &device, const Window &window, std::size_t largest_band) : Film(device, window, largest_band, plain_bytes) {}

Film::Film(Device &device, const FilmSettings &settings, std::size_t largest_band)
    : Film(device, settings.window(), largest_band, plain_bytes + (splats(settings) ? sizeof(PixelWeights) : 0)) {
    if (!splats(settings)) return;
    const std::size_t rows = bands_.begin()->params.rows;
    splatted_.emplace(Splatted{Kernel(device, "kernels/stages/add_splats.cl", "add_splats", {}),
                               Kernel(device, "kernels/stages/develop_splats.cl", "develop_splats", {}),
                               Bands<PixelWeights>(device, window_, rows * window_.width() * sizeof(PixelWeights)), correlated_pixels(settings)});
}

void Film::clear() {
    bands_.clear();
    if (splatted_) splatted_->weights.clear();
}

void Film::add(const Batch &batch, const Buffer<Sample> &samples, const Splats *splats) {
    const Access of_batch = several(samples, batch.params.samples);
    if (!splatted_ || splats == nullptr) {
        for (Band<FilmPixel> &band : bands_)
            add_samples_(batch.params.pixels, batch.params, band.params, batch.pixels, of_batch, updated(band.pixels), shared(clamped_));
        return;
    }
    for (std::size_t b = 0; b < bands_.size(); ++b)
        for (const Splat &splat : splats->all())
            splatted_->add(batch.params.pixels, batch.params, bands_[b].params, splat, several(splats->weights(), 2 * batch.params.samples),
                           batch.pixels, of_batch, updated(bands_[b].pixels), updated(splatted_->weights[b].pixels), shared(clamped_));
}

std::vector<vec3> Film::develop() {
    std::vector<vec3> picture;
    picture.reserve(window_.pixels());
    for (std::size_t b = 0; b < bands_.size(); ++b) {
        const Buffer<FilmPixel> &pixels = bands_[b].pixels;
        const std::size_t count = pixels.size();
        if (splatted_) {
            splatted_->develop(count, static_cast<uint>(count), pixels, splatted_->weights[b].pixels, picture_);
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
