/// Whitted's integrator (CACM 23(6) 1980): the loop over kernels/integrators/whitted.cl.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runtime/integrators/integrator.h"
#include "runtime/integrators/observation.h"
#include "runtime/integrators/whitted_parts.h"
#include "runtime/wavefront/aovs.h"
#include "runtime/wavefront/compaction.h"
#include "runtime/wavefront/levels.h"

namespace brandung {
namespace {

constexpr uint lights_per_block = 8;

class WhittedIntegrator : public Integrator {
public:
    explicit WhittedIntegrator(const IntegratorJob &job)
        : device_(job.device),
          scene_(job.on_device),
          filter_(job.filter),
          batch_(job.batch),
          interior_size_(job.compiled.interior_size),
          light_count_(job.compiled.header.lights.count),
          instances_(job.compiled.instances),
          branching_(branching(job.compiled)),
          params_{job.scene.integrator.max_depth, job.scene.integrator.threshold},
          generate_(job.device, "kernels/stages/generate_camera_rays.cl", "generate_camera_rays", scene_.lists()),
          evaluate_(job.device, "kernels/stages/evaluate_surfaces.cl", "evaluate_surfaces", scene_.lists()),
          shade_(job.device, whitted_cl, "shade_whitted", scene_.lists()),
          accumulate_(job.device, "kernels/stages/accumulate.cl", "accumulate", scene_.lists()),
          intersect_together_(tracing_kernel(job, true, &Traversal::closest_hit)),
          levels_(job.device, job.batch, branching_, branching_ == 0 ? 1 : params_.max_depth, job.compiled.interior_size, instances_, job.on_step),
          hits_(job.device, job.batch),
          hit_instances_(job.device, instances_ ? job.batch : 0),
          points_(job.device, job.batch),
          interfaces_(job.device, job.batch),
          directions_(job.device, job.batch),
          contributions_(job.device, job.batch),
          refused_(job.device, 1),
          no_bytes_(job.device, 0),
          no_words_(job.device, 0),
          no_floats_(job.device, 0),
          no_tints_(job.device, 0),
          no_spectra_(job.device, 0),
          counter_(job.device, generate_.work_items(job.batch) * std::clamp(light_count_, 1u, lights_per_block)) {
        if (branching_ > 0) intersect_apart_.emplace(tracing_kernel(job, false, &Traversal::closest_hit));
        if (branching_ > 0) secondary_.emplace(job, branching_);
        if (job.compiled.transmits) media_.emplace(job);
        if (job.compiled.tints) pictures_.emplace(job);
        if (light_count_ > 0) shadows_.emplace(job, std::min(light_count_, lights_per_block));
        if (shadows_ && job.compiled.filters_shadows) shadow_filter_.emplace(job, shadows_->rays.size());
        note_limits(job);
        refused_.fill_zero();
    }

    void render(const Batch &batch, Buffer<Sample> &samples, WaveObserver *observer) override {
        observation_.reset();
        if (observer) observation_.emplace(device_, batch_, branching_, interior_size_);
        Level &first = levels_.start(batch.count());
        if (media_) start_interiors(first, batch);
        if (instances_) first.sources.fill_zero();
        generate_(batch.count(), batch.camera, batch.params, filter_, several(batch.pixels, 1.0 / batch.params.samples), batch.count(), first.rays,
                  first.paths, first.live, samples);
        while (const auto wave = levels_.next()) {
            if (observer) observation_->begin(*wave);
            trace(*wave);
            evaluate_(wave->count, scene_, *wave, wave->level.rays, hits_, hit_instances_, media_ ? media_->etas : no_floats_, points_, interfaces_,
                      directions_);
            if (pictures_)
                pictures_->look_up(wave->count, scene_, shared(scene_.texels()), *wave, wave->level.rays, hits_, hit_instances_, points_,
                                   pictures_->tints);
            if (batch.aovs && wave->generation == 0) batch.aovs->record(batch, scene_, *wave, hits_, hit_instances_, points_, tints());
            if (wave->children)
                spawn(*wave);
            else if (secondary_)
                secondary_->count_cut(wave->count, scene_.tables(), wave->count, points_, shared(secondary_->cut));
            for (uint light = 0; light == 0 || light < light_count_; light += lights_per_block) shade(*wave, light, samples);
            if (observer) show(*wave, *observer);
            if (wave->children) levels_.add_children(*wave, secondary_->compact.counts().read().at(0));
        }
        if (observer) observer->end(samples.read(0, batch.count()));
    }

    RayCounts counts() const override { return counter_.read(); }
    std::uint64_t refused() const override { return refused_.read().at(0); }
    std::uint64_t media_lost() const override { return media_ ? media_->lost.read().at(0) : 0; }
    std::size_t wave_bytes() const override {
        return levels_.bytes_at_most() + hits_.bytes() + hit_instances_.bytes() + points_.bytes() + interfaces_.bytes() + directions_.bytes() +
               contributions_.bytes() + counter_.bytes() + (media_ ? media_->bytes() : 0) + (pictures_ ? pictures_->tints.bytes() : 0) +
               (secondary_ ? secondary_->bytes() : 0) + (shadows_ ? shadows_->bytes() : 0) + (shadow_filter_ ? shadow_filter_->filters.bytes() : 0);
    }
    std::vector<Skipped> skipped() const override {
        std::vector<Skipped> skipped;
        if (!secondary_) skipped.push_back({"spawn_whitted", "no material reflects or transmits"});
        if (!media_) skipped.push_back({"find_interfaces", "no material transmits: refracted rays and lists of media are not stored"});
        if (!pictures_) skipped.push_back({"look_up_textures", "there are no pictures on surfaces or as background, and no vertex colours"});
        if (!shadows_) skipped.push_back({"trace_shadow_rays", "there are no lights, nor emissive surfaces that light anything"});
        if (!shadow_filter_) skipped.push_back({"filter_shadow_rays", no_filter_});
        return skipped;
    }
    std::vector<Bias> biases() const override {
        std::vector<Bias> biases;
        if (!secondary_) return biases;
        if (const std::uint64_t cut = secondary_->cut.read().at(0); cut > 0)
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

    /// All rays of a batch begin in the media that the eye is in.
    static void start_interiors(Level &first, const Batch &batch) {
        if (std::all_of(batch.interior.begin(), batch.interior.end(), [](uint entry) { return entry == 0; })) return first.interiors.fill_zero();
        std::vector<uint> interiors;
        for (uint i = 0; i < batch.count(); ++i) interiors.insert(interiors.end(), batch.interior.begin(), batch.interior.end());
        first.interiors.write(interiors);
    }

    void trace(const Wave &wave) {
        Kernel &intersect = are_coherent(wave.generation) ? intersect_together_ : *intersect_apart_;
        intersect(wave.count, scene_, wave, wave.level.rays, wave.level.sources, hits_, hit_instances_, media_ ? media_->crowded : no_bytes_,
                  shared(counter_.tallies()));
        counter_.add(intersect.work_items(wave.count));
        if (!media_) return;
        media_->find(wave.count, scene_, wave, wave.level.rays, wave.level.sources, hits_, hit_instances_, media_->crowded,
                     media(wave.level.interiors), media(media_->beyond), media_->etas, shared(media_->lost), shared(counter_.tallies()));
        counter_.add(media_->find.work_items(wave.count));
    }

    void spawn(const Wave &wave) {
        Level &below = *wave.children;
        secondary_->spawn(wave.count, scene_.tables(), params_, wave, wave.level.paths, points_, interfaces_, directions_, hit_instances_,
                          media(wave.level.interiors), media(media_ ? media_->beyond : no_words_), wave.base, children(below.rays),
                          children(below.paths), children(below.sources), several(below.interiors, branching_ * interior_size_),
                          children(secondary_->alive));
        const uint slots = wave.count * branching_;
        secondary_->compact(secondary_->alive, slots, slots, 1, wave.base, below.end, below.live);
    }

    /// A block of lights, from `light` on.
    void shade(const Wave &wave, uint light, Buffer<Sample> &samples) {
        const uint rows = std::min(light_count_ - light, lights_per_block), stride = shadows_ ? shadows_->stride : 0;
        if (rows > 0) trace_shadows(wave, light, rows);
        const Buffer<std::uint8_t> &visible = shadows_ ? shadows_->visible : no_bytes_;
        shade_(wave.count, scene_.tables(), wave, uint{light == 0}, light, rows, stride, wave.level.paths, points_, directions_, tints(),
               several(visible, rows), several(shadow_filter_ ? shadow_filter_->filters : no_spectra_, rows), contributions_);
        accumulate_(wave.count, wave, wave.level.paths, contributions_, updated(samples), shared(refused_));
        if (observation_) record_lights(wave, rows);
    }

    /// Arrays that have a record for each child of an item, or each entry of its list of media.
    template <class T> Access children(const Buffer<T> &buffer) const { return several(buffer, branching_); }
    Access media(const Buffer<uint> &buffer) const { return several(buffer, interior_size_); }

    const Buffer<Tints> &tints() const { return pictures_ ? pictures_->tints : no_tints_; }

    void trace_shadows(const Wave &wave, uint light, uint rows) {
        Shadows &shadows = *shadows_;
        const uint count = wave.count;
        shadows.spawn(Grid(count, rows), scene_.tables(), wave, light, shadows.stride, wave.level.paths, points_, interfaces_,
                      in_rows(shadows.rays, shadows.rows), in_rows(shadows.visible, shadows.rows));
        shadows.compact(shadows.visible, shadows.stride, count, rows, 0, 0, shadows.live);
        if (observation_) record_shadow_rays(wave, light, rows);
        Kernel &trace = are_shadow_rays_coherent(wave.generation) ? shadows.trace_together : *shadows.trace_apart;
        const Access live = in_rows(shadows.live, shadows.rows), rays = in_rows(shadows.rays, shadows.rows);
        const Access visible = in_rows(shadows.visible, shadows.rows), counts = shared(shadows.compact.counts());
        trace(Grid(count, rows), scene_, live, counts, shadows.stride, rays, hit_instances_, visible, shared(counter_.tallies()));
        counter_.add(trace.work_items(count) * rows);
        if (!shadow_filter_) return;
        shadow_filter_->filter(Grid(count, rows), scene_, live, counts, shadows.stride, rays, hit_instances_, visible,
                               in_rows(shadow_filter_->filters, shadows.rows));
    }

    /// A block of lights from `light` on, before its shadow rays are traced.
    void record_shadow_rays(const Wave &wave, uint light, uint rows) {
        LightBlockRecords &block = observation_->records.lights.emplace_back();
        for (uint row = 0; row < rows; ++row) {
            const std::size_t first = std::size_t{row} * shadows_->stride;
            block.lights.push_back({light + row, shadows_->rays.read(first, wave.count), shadows_->visible.read(first, wave.count), {}, {}, {}});
        }
    }

    /// The same after they are, with the share of each light.
    void record_lights(const Wave &wave, uint rows) {
        if (rows == 0) observation_->records.lights.emplace_back();
        LightBlockRecords &block = observation_->records.lights.back();
        for (uint row = 0; row < rows; ++row) {
            LightRecords &light = block.lights[row];
            observation_->record_shadows(wave, light, std::size_t{row} * shadows_->stride, shadows_->visible,
                                         shadow_filter_ ? &shadow_filter_->filters : nullptr);
            light.radiance = radiance(wave, 0, light.row, 1);
        }
        block.contributions = contributions_.read(0, wave.count);
    }

    /// What visible lights, and with_unlit what needs none, give at throughput 1.
    std::vector<Spectrum> radiance(const Wave &wave, uint with_unlit, uint light, uint lights) {
        Observation &o = *observation_;
        shade_(wave.count, scene_, wave, with_unlit, light, lights, 0u, o.unit_paths, points_, directions_, tints(), o.all_visible, o.arriving,
               o.radiance);
        return o.radiance.read(0, wave.count);
    }

    /// Adds what the buffers still hold at the end of a wave.
    void show(const Wave &wave, WaveObserver &observer) {
        Observation &o = *observation_;
        const Buffer<uint> &beyond = media_ ? media_->beyond : no_words_;
        o.record_hits(wave, hits_, hit_instances_, points_, interfaces_, directions_, beyond);
        if (pictures_) o.records.tints = pictures_->tints.read(0, wave.count);
        o.records.unlit = radiance(wave, 1, 0, 0);
        if (secondary_) {
            secondary_->spawn(wave.count, scene_, params_, wave, o.unit_paths, points_, interfaces_, directions_, hit_instances_,
                              wave.level.interiors, beyond, 0u, o.rays, o.paths, o.sources, o.interiors, o.alive);
            o.record_children(wave.children ? &secondary_->alive : nullptr);
        }
        observer.see(o.records);
    }

    Device &device_;
    const DeviceScene &scene_;
    const Filter &filter_;
    uint batch_, interior_size_, light_count_;
    bool instances_;  ///< whether the scene has some
    uint branching_;
    WhittedParams params_;
    Kernel generate_, evaluate_, shade_, accumulate_;
    Kernel intersect_together_;
    std::optional<Kernel> intersect_apart_;
    Levels levels_;
    Buffer<Hit> hits_;
    Buffer<uint> hit_instances_;  ///< of the hits, in scenes with instances
    Buffer<SurfacePoint> points_;
    Buffer<SurfaceInterface> interfaces_;
    Buffer<vec3> directions_;  ///< back along the rays
    Buffer<Spectrum> contributions_;
    Buffer<uint> refused_;
    Buffer<std::uint8_t> no_bytes_;  ///< these stand for arrays that the scene does without
    Buffer<uint> no_words_;
    Buffer<float> no_floats_;
    Buffer<Tints> no_tints_;
    Buffer<Spectrum> no_spectra_;
    RayCounter counter_;
    std::optional<Interfaces> media_;
    std::optional<Pictures> pictures_;
    std::optional<Secondary> secondary_;
    std::optional<Shadows> shadows_;
    std::optional<ShadowFilter> shadow_filter_;
    std::string no_filter_;  ///< why there is none
    std::vector<NotShown> not_shown_;
    std::optional<Observation> observation_;  ///< only where a batch is observed
};

}  // namespace

std::unique_ptr<Integrator> make_whitted(const IntegratorJob &job) { return std::make_unique<WhittedIntegrator>(job); }

}  // namespace brandung
