/// Whitted's integrator (CACM 23(6) 1980): the loop over kernels/integrators/whitted.cl.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runtime/integrators/camera_rays.h"
#include "runtime/integrators/observation.h"
#include "runtime/integrators/surfaces.h"
#include "runtime/integrators/whitted_parts.h"
#include "runtime/wavefront/levels.h"

namespace brandung {
namespace {

constexpr uint lights_per_block = 8;

class WhittedIntegrator : public Integrator {
public:
    explicit WhittedIntegrator(const IntegratorJob &job)
        : device_(job.device),
          scene_(job.on_device),
          batch_(job.batch),
          light_count_(job.compiled.header.lights.count),
          branching_(branching(job.compiled)),
          params_{job.scene.integrator.max_depth, job.scene.integrator.threshold},
          generate_(job),
          shade_(job.device, whitted_cl, "shade_whitted", scene_.lists()),
          accumulate_(job.device, "kernels/stages/accumulate.cl", "accumulate", scene_.lists()),
          surfaces_(job, branching_ > 0, generate_.work_items(job.batch) * std::clamp(light_count_, 1u, lights_per_block)),
          levels_(job.device, job.batch, {branching_, branching_}, branching_ == 0 ? 1 : params_.max_depth,
                  {.interior_size = job.compiled.interior_size, .place_words = surfaces_.place_words}, job.on_step),
          contributions_(job.device, job.batch),
          refused_(job.device, 1),
          no_spectra_(job.device, 0) {
        if (branching_ > 0) secondary_.emplace(job, branching_);
        if (light_count_ > 0) shadows_.emplace(job, job.batch, std::min(light_count_, lights_per_block), branching_ > 0);
        if (light_count_ > 0) spawn_shadow_rays_.emplace(job.device, whitted_cl, "spawn_shadow_rays", scene_.lists());
        if (shadows_ && job.compiled.filters_shadows) shadow_filter_.emplace(job, shadows_->rays.size());
        note_limits(job);
        refused_.fill_zero();
    }

    void render(const Batch &batch, Buffer<Sample> &samples, WaveObserver *observer) override {
        observation_.reset();
        if (observer) observation_.emplace(device_, batch_, branching_, surfaces_.interior_size(), surfaces_.place_words);
        Level &first = levels_.start(batch.count());
        surfaces_.start(first, batch);
        generate_(batch, first, samples);
        while (const auto wave = levels_.next()) {
            if (observer) observation_->begin(*wave, surfaces_.stay_together(*wave));
            surfaces_.find(*wave, batch);
            std::optional<Reading<uint>> children;  // how many there are is known before the rest of the wave is done
            if (wave->children)
                children.emplace(spawn(*wave));
            else if (secondary_)
                secondary_->cut.count(*wave, scene_, surfaces_.points);
            for (uint light = 0; light == 0 || light < light_count_; light += lights_per_block) shade(*wave, light, samples);
            if (observer) show(*wave, *observer);
            if (children) levels_.add_children(*wave, children->items()[0]);
        }
        if (observer) observer->end(samples.read(0, batch.count()));
    }

    RayCounts counts() const override { return surfaces_.counter.read(); }
    std::uint64_t refused() const override { return refused_.read().at(0); }
    std::uint64_t media_lost() const override { return surfaces_.media_lost(); }
    std::size_t wave_bytes() const override {
        return levels_.bytes_at_most() + generate_.bytes() + surfaces_.bytes() + contributions_.bytes() + (secondary_ ? secondary_->bytes() : 0) +
               (shadows_ ? shadows_->bytes() : 0) + (shadow_filter_ ? shadow_filter_->filters.bytes() : 0);
    }
    std::vector<Skipped> skipped() const override {
        std::vector<Skipped> skipped;
        if (!secondary_) skipped.push_back({"spawn_whitted", "no material reflects or transmits"});
        surfaces_.add_skipped(skipped);
        if (!shadows_) skipped.push_back({"trace_shadow_rays", "there are no lights, nor emissive surfaces that light anything"});
        if (!shadow_filter_) skipped.push_back({"filter_shadow_rays", no_filter_});
        return skipped;
    }
    std::vector<Bias> biases() const override {
        std::vector<Bias> biases;
        if (!secondary_) return biases;
        if (const std::uint64_t cut = secondary_->cut.read(); cut > 0)
            biases.push_back({"depth limit", fmt::format("integrator.max_depth {} ended {} rays whose surface sends more", params_.max_depth, cut)});
        if (params_.threshold > 0)
            biases.push_back({"adaptive depth", fmt::format("integrator.threshold {:g} ends rays that count less", params_.threshold)});
        return biases;
    }
    std::vector<NotShown> not_shown() const override { return not_shown_; }

private:
    /// What must be said of the scene and its settings, which are not kept.
    void note_limits(const IntegratorJob &job) {
        const bool requested = job.scene.integrator.filtered_shadows;
        no_filter_ = requested ? "no material transmits, or nothing is lit" : "shadows are opaque; --shadows filtered asks for others";
        not_shown_.push_back({"indirect light",
                              "whitted follows mirrored and refracted rays from the eye; what surfaces reflect diffusely onto each "
                              "other is not computed, ambient light stands for it"});
        if (job.compiled.transmits)
            not_shown_.push_back({"caustics", "light is not bent or gathered by mirrors and transparent objects on its way to a surface"});
        if (job.compiled.transmits && !requested)
            not_shown_.push_back({"light through transparent objects", "shadows are opaque; --shadows filtered lets it through, straight on"});
        if (job.compiled.header.background_texture != 0)
            not_shown_.push_back({"light from the background on diffuse surfaces", "it is seen directly, in mirrors and in glass"});
        if (job.compiled.dark_emitters > 0) not_shown_.push_back({"light of emissive surfaces", "they are seen, but integrator.light_samples is 0"});
    }

    /// The rays that go on, which are counted.
    Reading<uint> spawn(const Wave &wave) {
        Level &below = *wave.children;
        secondary_->spawn(wave.count, scene_.tables(), params_, wave, wave.level.paths, surfaces_.points, surfaces_.interfaces, surfaces_.directions,
                          surfaces_.places(), surfaces_.in_lists(wave.level.interiors), surfaces_.in_lists(surfaces_.beyond()), wave.base,
                          children(below.rays), children(below.paths), several(below.sources, branching_ * surfaces_.place_words),
                          several(below.interiors, branching_ * surfaces_.interior_size()), children(secondary_->alive));
        const uint slots = wave.count * branching_;
        secondary_->compact(secondary_->alive, slots, slots, 1, wave.base, below.end, below.live);
        return secondary_->compact.counts().start_reading();
    }

    /// A block of lights, from `light` on.
    void shade(const Wave &wave, uint light, Buffer<Sample> &samples) {
        const uint rows = std::min(light_count_ - light, lights_per_block), stride = shadows_ ? shadows_->stride : 0;
        if (rows > 0) trace_shadows(wave, light, rows);
        const Buffer<std::uint8_t> &visible = shadows_ ? shadows_->visible : surfaces_.no_bytes;
        shade_(wave.count, scene_.tables(), wave, uint{light == 0}, light, rows, stride, wave.level.paths, surfaces_.places(), surfaces_.points,
               surfaces_.directions, surfaces_.tints(), several(visible, rows), several(shadow_filter_ ? shadow_filter_->filters : no_spectra_, rows),
               contributions_);
        accumulate_(wave.count, wave, wave.level.paths, contributions_, updated(samples), shared(refused_));
        if (observation_) record_lights(wave, light, rows);
    }

    /// Arrays that have a record for each child of an item.
    template <class T> Access children(const Buffer<T> &buffer) const { return several(buffer, branching_); }

    void trace_shadows(const Wave &wave, uint light, uint rows) {
        Shadows &shadows = *shadows_;
        const uint count = wave.count;
        (*spawn_shadow_rays_)(Grid(count, rows), scene_.tables(), wave, light, shadows.stride, wave.level.paths, surfaces_.places(), surfaces_.points,
                              surfaces_.interfaces, in_rows(shadows.rays, shadows.rows), in_rows(shadows.visible, shadows.rows));
        shadows.list(count, rows);
        if (observation_) record_shadow_rays(wave, light, rows);
        shadows.trace(scene_, wave.generation, count, rows, surfaces_.places(), surfaces_.counter);
        if (!shadow_filter_) return;
        shadow_filter_->filter(Grid(count, rows), scene_, in_rows(shadows.live, shadows.rows), shared(shadows.compact.counts()), shadows.stride,
                               in_rows(shadows.rays, shadows.rows), surfaces_.places(), in_rows(shadows.visible, shadows.rows),
                               in_rows(shadow_filter_->filters, shadows.rows));
    }

    /// A block of lights from `light` on, before its shadow rays are traced.
    void record_shadow_rays(const Wave &wave, uint light, uint rows) {
        LightBlockRecords &block = observation_->records.lights.emplace_back();
        for (uint row = 0; row < rows; ++row) {
            const std::size_t first = std::size_t{row} * shadows_->stride;
            block.lights.push_back({.rows = std::vector<uint>(wave.count, light + row),
                                    .rays = shadows_->rays.read(first, wave.count),
                                    .asked = shadows_->visible.read(first, wave.count)});
        }
    }

    /// The same after they are, with the share of each light.
    void record_lights(const Wave &wave, uint first_light, uint rows) {
        if (rows == 0) observation_->records.lights.emplace_back();
        LightBlockRecords &block = observation_->records.lights.back();
        for (uint row = 0; row < rows; ++row) {
            LightRecords &light = block.lights[row];
            observation_->record_shadows(wave, light, std::size_t{row} * shadows_->stride, shadows_->visible,
                                         shadow_filter_ ? &shadow_filter_->filters : nullptr);
            light.radiance = radiance(wave, 0, first_light + row, 1);
        }
        block.contributions = contributions_.read(0, wave.count);
    }

    /// What visible lights, and with_unlit what needs none, give at throughput 1.
    std::vector<Spectrum> radiance(const Wave &wave, uint with_unlit, uint light, uint lights) {
        Observation &o = *observation_;
        shade_(wave.count, scene_, wave, with_unlit, light, lights, 0u, o.unit_paths, surfaces_.places(), surfaces_.points, surfaces_.directions,
               surfaces_.tints(), o.all_visible, o.arriving, o.radiance);
        return o.radiance.read(0, wave.count);
    }

    /// Adds what the buffers still hold at the end of a wave.
    void show(const Wave &wave, WaveObserver &observer) {
        Observation &o = *observation_;
        o.record_hits(wave, surfaces_.hits, surfaces_.hit_instances, surfaces_.points, surfaces_.interfaces, surfaces_.directions,
                      surfaces_.beyond());
        if (surfaces_.pictures) o.records.tints = surfaces_.tints().read(0, wave.count);
        o.records.unlit = radiance(wave, 1, 0, 0);
        if (secondary_) {
            secondary_->spawn(wave.count, scene_, params_, wave, o.unit_paths, surfaces_.points, surfaces_.interfaces, surfaces_.directions,
                              surfaces_.places(), wave.level.interiors, surfaces_.beyond(), 0u, o.rays, o.paths, o.sources, o.interiors, o.alive);
            o.record_children(wave.children ? &secondary_->alive : nullptr);
        }
        observer.see(o.records);
    }

    Device &device_;
    const DeviceScene &scene_;
    uint batch_, light_count_;
    uint branching_;
    WhittedParams params_;
    CameraRays generate_;
    Kernel shade_, accumulate_;
    Surfaces surfaces_;
    Levels levels_;
    Buffer<Spectrum> contributions_;
    Buffer<uint> refused_;
    Buffer<Spectrum> no_spectra_;  ///< stands for filters of shadows
    std::optional<Secondary> secondary_;
    std::optional<Shadows> shadows_;
    std::optional<Kernel> spawn_shadow_rays_;
    std::optional<ShadowFilter> shadow_filter_;
    std::string no_filter_;  ///< why there is none
    std::vector<NotShown> not_shown_;
    std::optional<Observation> observation_;  ///< only where a batch is observed
};

}  // namespace

std::unique_ptr<Integrator> make_whitted(const IntegratorJob &job) { return std::make_unique<WhittedIntegrator>(job); }

}  // namespace brandung
