#include "runtime/wavefront/aovs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/filters/splat.h"
#include "scene/filters/filter.h"
#include "scene/formats/limits.h"

namespace brandung {
namespace {

bool is_mean(const AovKind &kind) { return kind.what == AovKind::filtered || kind.what == AovKind::length; }

/// Bytes of a pixel on the device.
std::size_t pixel_bytes(const AovKind &kind) { return is_mean(kind) ? sizeof(AovPixel) : kind.what == AovKind::number ? sizeof(uint) : 0; }

void check_memory(const Device &device, const FilmSettings &film) {
    std::size_t bytes = 0;
    for (const uint kind : film.aovs) bytes += film.window().pixels() * pixel_bytes(aov_kinds()[kind]);
    if (bytes > device.info().memory)
        throw Error(fmt::format("AOVs of {} x {} pixels take {} MiB, more than '{}' has ({} MiB)", film.window().width(), film.window().height(),
                                bytes >> 20, device.info().name, device.info().memory >> 20));
}

/// 2^38 is more than any coordinate of a hit and any distance from a ray's beginning to one: the diagonal of a cube is less than twice its edge.
float scale_of_lengths(float extent, const CameraDescription &camera, PictureSize size) {
    vec3 from = glm::abs(camera.from);
    for (const CameraKey &key : camera.keys) from = glm::max(from, glm::abs(key.from));
    const float spread = static_cast<float>(camera_kinds()[camera.kind].spread(camera, size));
    const float reach = 2 * (extent + std::max({from.x, from.y, from.z}) + spread);
    return reach > 0 ? std::exp2(38 - std::ceil(std::log2(reach))) : 1;
}

constexpr float scale_of_units = 0x1p32f;
/// Sums of what is splatted, which has units: a sample counts in so many pixels at most, and a pixel so many of its neighbours' samples.
constexpr float most_splats = (2 * max_splat_radius + 1) * (2 * max_splat_radius + 1);
static_assert(scale_of_units * most_splats * max_samples < 0x1p63f);
constexpr double weight_unit = 1.0 / SPLAT_UNIT;

float scale_of(const AovKind &kind, float extent, const CameraDescription &camera, PictureSize size) {
    return kind.what == AovKind::length ? scale_of_lengths(extent, camera, size) : scale_of_units;
}

std::string file_of(const AovKind &kind) { return fmt::format("kernels/aovs/{}.cl", kind.name); }

/// One per component in use.
void add_channels(const AovKind &kind, const std::vector<AovPixel> &pixels, float scale, std::vector<PictureChannel> &channels) {
    for (std::size_t c = 0; c < kind.channels.size(); ++c) {
        PictureChannel &channel = channels.emplace_back(PictureChannel{kind.channels[c], {}, {}});
        for (const AovPixel &pixel : pixels)
            channel.floats.push_back(pixel.weights
                                         ? static_cast<float>(static_cast<double>(pixel.sums[c]) /
                                                              (static_cast<double>(pixel.weights) * weight_unit * static_cast<double>(scale)))
                                         : kind.nothing);
    }
}

/// Of what the film knows.
void add_channels(const AovKind &kind, const std::vector<FilmPixel> &pixels, const std::vector<PixelWeights> &weights,
                  std::vector<PictureChannel> &channels) {
    const std::size_t first = channels.size();
    for (const std::string &name : kind.channels) channels.push_back({name, {}, {}});
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const FilmPixel &pixel = pixels[i];
        if (kind.what == AovKind::count) {
            channels[first].numbers.push_back(pixel.counts[0] + pixel.counts[1]);
            continue;
        }
        const vec3 error = standard_error(weights.empty() ? PixelHalves(pixel) : PixelHalves(pixel, weights[i]));
        for (int c = 0; c < 3; ++c) channels[first + static_cast<std::size_t>(c)].floats.push_back(error[c]);
    }
}

}  // namespace

Aovs::Aovs(Device &device, const Scene &scene, const CompiledScene &compiled, const DeviceScene &on_device, const CameraDescription &camera,
           uint batch, std::size_t largest_band)
    : size_{scene.film.width, scene.film.height}, extent_(compiled.header.world.extent) {
    const Window window = scene.film.window();
    check_memory(device, scene.film);
    const std::size_t largest = std::min<std::size_t>(largest_band, device.info().largest_allocation);
    for (const uint number : scene.film.aovs) {
        const AovKind &kind = aov_kinds()[number];
        if (is_mean(kind))
            means_.push_back({kind, scale_of(kind, extent_, camera, size_), Kernel(device, file_of(kind), "record_aov", on_device.lists()),
                              Buffer<vec3>(device, batch), Bands<AovPixel>(device, window, largest)});
        if (kind.what == AovKind::number)
            numbers_.push_back({kind, Kernel(device, file_of(kind), "record_number", on_device.lists()), Bands<uint>(device, window, largest)});
        if (kind.what == AovKind::count || kind.what == AovKind::error) of_film_.push_back(&kind);
    }
    if (!means_.empty() && (compiled.groups_hits() || !camera_kinds()[camera.kind].sees_everywhere))
        spreading_.emplace(Spreading{Kernel(device, "kernels/stages/spread_values.cl", "spread_values", Sources()), Buffer<vec3>(device, batch)});
    const auto is_splatted = [&](const Mean &mean) { return mean.kind.what == AovKind::filtered && splats(scene.film); };
    if (!std::all_of(means_.begin(), means_.end(), is_splatted)) add_.emplace(device, "kernels/stages/add_aov.cl", "add_aov", Sources());
    if (std::any_of(means_.begin(), means_.end(), is_splatted))
        add_splats_.emplace(device, "kernels/stages/add_aov_splats.cl", "add_aov_splats", Sources());
}

void Aovs::begin(const CameraDescription &camera) {
    for (Mean &mean : means_) {
        mean.scale = scale_of(mean.kind, extent_, camera, size_);
        mean.sums.clear();
    }
    for (Number &number : numbers_) number.numbers.clear();
}

void Aovs::clear_values() {
    for (Mean &mean : means_) {
        if (mean.kind.what == AovKind::filtered)
            mean.values.fill_zero();
        else
            mean.values.write(std::vector<vec3>(mean.values.size(), vec3(std::numeric_limits<float>::infinity(), 0, 0)));
    }
}

void Aovs::record(const Batch &batch, const DeviceScene &scene, const Wave &wave, const Buffer<Hit> &hits, const Buffer<uint> &instances,
                  const Buffer<SurfacePoint> &points, const Buffer<Tints> &tints) {
    for (Mean &mean : means_) {
        mean.record(wave.count, scene, wave, wave.level.rays, hits, points, tints, spreading_ ? spreading_->listed : mean.values);
        if (spreading_) spreading_->spread(wave.count, wave, spreading_->listed, data_dependent(mean.values));
    }
    for (Number &number : numbers_)
        for (Band<uint> &band : number.numbers)
            number.record(wave.count, batch.params, band.params, wave, several(batch.pixels, 1.0 / batch.params.samples), hits, instances,
                          data_dependent(band.pixels));
}

void Aovs::add(const Batch &batch, Filter &filter) {
    for (Mean &mean : means_) {
        const bool is_filtered = mean.kind.what == AovKind::filtered;
        if (is_filtered) filter.weigh(batch, mean.values);
        for (Band<AovPixel> &band : mean.sums) {
            const Access values = several(mean.values, batch.params.samples);
            if (is_filtered && filter.splats())
                add_splats(batch, *filter.splats(), mean.scale, values, band);
            else
                (*add_)(batch.params.pixels, batch.params, band.params, mean.scale, batch.pixels, values, updated(band.pixels));
        }
    }
}

void Aovs::add_splats(const Batch &batch, const Splats &splats, float scale, const Access &values, Band<AovPixel> &band) {
    for (const Splat &splat : splats.all())
        (*add_splats_)(batch.params.pixels, batch.params, band.params, scale, splat, several(splats.weights(), 2 * batch.params.samples),
                       batch.pixels, values, updated(band.pixels));
}

std::vector<PictureChannel> Aovs::develop(const Film &film) const {
    std::vector<PictureChannel> channels;
    for (const Mean &mean : means_) add_channels(mean.kind, mean.sums.read(), mean.scale, channels);
    for (const Number &number : numbers_) {
        channels.push_back({number.kind.channels[0], {}, number.numbers.read()});
        for (uint &n : channels.back().numbers) --n;  // from 0 on; the largest for none
    }
    if (of_film_.empty()) return channels;
    const std::vector<FilmPixel> pixels = film.read();
    const std::vector<PixelWeights> weights = film.read_weights();
    for (const AovKind *kind : of_film_) add_channels(*kind, pixels, weights, channels);
    return channels;
}

std::size_t Aovs::bytes() const {
    std::size_t bytes = spreading_ ? spreading_->listed.bytes() : 0;
    for (const Number &number : numbers_) bytes += number.numbers.bytes();
    for (const Mean &mean : means_) bytes += mean.values.bytes() + mean.sums.bytes();
    return bytes;
}

}  // namespace brandung
