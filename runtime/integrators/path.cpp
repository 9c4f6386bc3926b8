/// Path tracing, with bundles or without: the loop over kernels/integrators/path.cl.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runtime/integrators/camera_rays.h"
#include "runtime/integrators/cut_rays.h"
#include "runtime/integrators/observation.h"
#include "runtime/integrators/shadows.h"
#include "runtime/integrators/surfaces.h"

namespace brandung {
namespace {

constexpr const char *path_cl = "kernels/integrators/path.cl";

/// What asks for light at surfaces, and what comes of it.
struct AskedLights {
    /// Of launches over so many items in so many rows.
    AskedLights(const IntegratorJob &job, uint items, uint rows) : shadows(job, items, rows, true), light(job.device, shadows.rays.size()) {}
    Shadows shadows;
    Buffer<Spectrum> light;  ///< what each shadow ray adds where nothing is in its way
    std::size_t bytes() const { return shadows.bytes() + light.bytes(); }
};

class PathIntegrator : public Integrator {
public:
    explicit PathIntegrator(const IntegratorJob &job)
        : device_(job.device),
          scene_(job.on_device),
          params_{job.scene.integrator.max_depth, job.scene.integrator.roulette_depth, job.scene.integrator.bundles_in_use()},
          asks_(job.compiled.header.light_choices.count > 0),
          rows_(std::max(job.compiled.bundle, asks_ ? params_.bundles.light : 1)),
          unmet_lights_(!job.scene.lights.empty() && job.compiled.ideal),
          generate_(job),
          spawn_(job.device, path_cl, "spawn_path", scene_.lists()),
          shade_(job.device, path_cl, "shade_path", scene_.lists()),
          accumulate_(job.device, "kernels/stages/accumulate.cl", "accumulate", scene_.lists()),
          levels_(job.device, job.batch, {rows_, 1}, params_.max_depth + 1,
                  {.interior_size = job.compiled.interior_size, .place_words = job.compiled.place_words(), .pdfs = true}, job.on_step),
          surfaces_(job, true, std::max(generate_.work_items(job.batch), rows_ * generate_.work_items(levels_.wave_size(0)))),
          compact_(job.device, levels_.capacity(), 1),
          cut_(job, MATERIAL_LIT | MATERIAL_IDEAL),
          alive_(job.device, levels_.capacity()),
          contributions_(job.device, job.batch),
          refused_(job.device, 1),
          no_rays_(job.device, 0),
          no_spectra_(job.device, 0) {
        if (asks_) asked_.emplace(job, levels_.wave_size(0), rows_);
        refused_.fill_zero();
    }

    void render(const Batch &batch, Buffer<Sample> &samples, WaveObserver *observer) override {
        observation_.reset();
        if (observer) observation_.emplace(device_, levels_.capacity(), 0, surfaces_.interior_size(), surfaces_.place_words);
        Level &first = levels_.start(batch.count());
        surfaces_.start(first, batch);
        generate_(batch, first, samples);
        while (const auto wave = levels_.next()) {
            if (observer) observation_->begin(*wave, surfaces_.stay_together(*wave));
            surfaces_.find(*wave, batch);
            std::optional<Reading<uint>> children;  // how many there are is known before the rest of the wave is done
            if (wave->children)
                children.emplace(spawn(*wave, batch));
            else
                cut_.count(*wave, scene_, surfaces_.points);
            shade(*wave);
            accumulate_(wave->count, *wave, wave->level.paths, contributions_, updated(samples), shared(refused_));
            if (observer) show(*wave, batch, *observer);
            if (children) levels_.add_children(*wave, children->items()[0]);
        }
        if (observer) observer->end(samples.read(0, batch.count()));
    }

    RayCounts counts() const override { return surfaces_.counter.read(); }
    std::uint64_t refused() const override { return refused_.read().at(0); }
    std::uint64_t media_lost() const override { return surfaces_.media_lost(); }
    std::size_t wave_bytes() const override {
        return levels_.bytes_at_most() + generate_.bytes() + surfaces_.bytes() + compact_.bytes() + alive_.bytes() + contributions_.bytes() +
               (asked_ ? asked_->bytes() : 0);
    }
    std::vector<Skipped> skipped() const override {
        std::vector<Skipped> skipped;
        surfaces_.add_skipped(skipped);
        if (!asked_) skipped.push_back({"trace_shadow_rays", "there are no lights, nor surfaces or pictures all around that light anything"});
        return skipped;
    }
    std::vector<Bias> biases() const override {
        const std::uint64_t cut = cut_.read();
        if (cut == 0) return {};
        return {{"depth limit", fmt::format("integrator.max_depth {} ended {} paths whose surface sends more", params_.max_depth, cut)}};
    }
    std::vector<NotShown> not_shown() const override {
        if (!unmet_lights_) return {};
        return {{"light of points and directions over mirrors, through smooth glass and masks", "paths cannot meet lights without size by chance"}};
    }

private:
    /// The rays that go on, which are counted, and those that ask for light.
    Reading<uint> spawn(const Wave &wave, const Batch &batch) {
        Level &below = *wave.children;
        const bool lit = asked_.has_value();
        const uint rows = rows_of(wave), slots = rows * wave.count;
        if (lit) asked_->shadows.share_among(rows);
        spawn_(Grid(wave.count, rows), scene_.tables(), params_, wave.generation + 1, batch.params, several(batch.pixels, 1.0 / batch.params.samples),
               wave, wave.level.paths, surfaces_.points, surfaces_.interfaces, surfaces_.directions, surfaces_.places(), surfaces_.tints(),
               surfaces_.in_lists(wave.level.interiors), surfaces_.in_lists(surfaces_.beyond()), shared(scene_.texels()), wave.base,
               lit ? asked_->shadows.stride : 0u, in_rows(below.rays, rows), in_rows(below.paths, rows), in_rows(below.pdfs, rows),
               surfaces_.in_places(below.sources), surfaces_.in_lists(below.interiors), in_rows(alive_, rows),
               in_rows(lit ? asked_->shadows.rays : no_rays_, rows), in_rows(lit ? asked_->light : no_spectra_, rows),
               in_rows(lit ? asked_->shadows.visible : surfaces_.no_bytes, rows));
        compact_(alive_, slots, slots, 1, wave.base, below.end, below.live);
        Reading<uint> count = compact_.counts().start_reading();
        if (lit) ask(wave);
        return count;
    }

    void ask(const Wave &wave) {
        asked_->shadows.list(wave.count, asking_rows(wave));
        if (observation_) record_shadow_rays(wave);
        asked_->shadows.trace(scene_, wave.generation, wave.count, asking_rows(wave), surfaces_.places(), surfaces_.counter);
    }

    /// Before they are traced.
    void record_shadow_rays(const Wave &wave) {
        const Shadows &shadows = asked_->shadows;
        LightBlockRecords &block = observation_->records.lights.emplace_back();
        for (uint row = 0; row < asking_rows(wave); ++row) {
            const std::size_t first = std::size_t{row} * shadows.stride;
            block.lights.push_back({.rays = shadows.rays.read(first, wave.count), .asked = shadows.visible.read(first, wave.count)});
        }
    }

    /// Adds what the buffers still hold at the end of a wave.
    void show(const Wave &wave, const Batch &batch, WaveObserver &observer) {
        observation_->record_hits(wave, surfaces_.hits, surfaces_.hit_instances, surfaces_.points, surfaces_.interfaces, surfaces_.directions,
                                  surfaces_.beyond());
        if (surfaces_.pictures) observation_->records.tints = surfaces_.tints().read(0, wave.count);
        if (observer.explains()) explain(wave, batch);
        observer.see(observation_->records);
    }

    /// What every ray adds, and what its path has chosen at its end.
    void explain(const Wave &wave, const Batch &batch) {
        Observation &o = *observation_;
        if (!describe_) describe_.emplace(device_, "kernels/stages/describe_paths.cl", "describe_paths", scene_.lists());
        const uint rows = rows_of(wave), slots = rows * wave.count;
        const Buffer<MetDescription> met(device_, wave.count);
        const Buffer<NextDescription> next(device_, slots);
        const Buffer<AskedDescription> asked(device_, asks_ ? slots : 0);
        (*describe_)(Grid(wave.count, rows), scene_, params_, wave.generation + 1, batch.params, batch.pixels, wave, wave.level.rays, o.unit_paths,
                     wave.level.pdfs, surfaces_.points, surfaces_.interfaces, surfaces_.directions, surfaces_.places(), surfaces_.tints(),
                     scene_.texels(), met, next, asked);
        o.records.met = met.read();
        record_next(wave, next.read());
        record_lights(wave, asked.read());
        shade_(wave.count, scene_, uint{wave.generation == 0}, wave, wave.level.rays, o.unit_paths, wave.level.pdfs, surfaces_.places(),
               surfaces_.points, surfaces_.interfaces, surfaces_.directions, surfaces_.tints(), 0u, 0u, surfaces_.no_bytes, no_spectra_, o.radiance);
        o.records.unlit = o.radiance.read(0, wave.count);
    }

    void record_next(const Wave &wave, const std::vector<NextDescription> &next) {
        for (uint row = 0; row < rows_of(wave); ++row) {
            ChildRecords &children = observation_->records.children.emplace_back();
            const std::size_t first = std::size_t{row} * wave.count;
            children.alive = wave.children ? alive_.read(first, wave.count) : std::vector<std::uint8_t>(wave.count, 0);
            for (std::size_t k = first; k < first + wave.count; ++k) {
                children.chosen.push_back(next[k]);
                children.rays.push_back(next[k].ray), children.weights.push_back(next[k].weight);
            }
        }
    }

    /// After the shadow rays were traced, where there are some.
    void record_lights(const Wave &wave, const std::vector<AskedDescription> &asked) {
        std::vector<LightBlockRecords> &blocks = observation_->records.lights;
        if (blocks.empty()) blocks.emplace_back();
        blocks.front().contributions = contributions_.read(0, wave.count);
        std::size_t k = 0, first = 0;
        for (LightRecords &light : blocks.front().lights) {
            light.visible = asked_->shadows.visible.read(first, wave.count), first += asked_->shadows.stride;
            for (uint i = 0; i < wave.count; ++i, ++k) {
                light.chosen.push_back(asked[k]);
                light.rows.push_back(asked[k].row), light.radiance.push_back(asked[k].radiance);
            }
        }
    }

    /// Of the bundles of a wave.
    uint rows_of(const Wave &wave) const { return wave.generation == 0 ? rows_ : 1; }
    uint asking_rows(const Wave &wave) const { return wave.generation == 0 ? params_.bundles.light : 1; }

    void shade(const Wave &wave) {
        const bool lit = asked_.has_value();
        const uint rows = lit && wave.children != nullptr ? asking_rows(wave) : 0;
        shade_(wave.count, scene_, uint{wave.generation == 0}, wave, wave.level.rays, wave.level.paths, wave.level.pdfs, surfaces_.places(),
               surfaces_.points, surfaces_.interfaces, surfaces_.directions, surfaces_.tints(), rows, lit ? asked_->shadows.stride : 0u,
               several(lit ? asked_->shadows.visible : surfaces_.no_bytes, rows), several(lit ? asked_->light : no_spectra_, rows), contributions_);
    }

    Device &device_;
    const DeviceScene &scene_;
    PathParams params_;
    bool asks_;          ///< whether there are lights of which to ask
    uint rows_;          ///< of the largest bundle
    bool unmet_lights_;  ///< whether there are lights without size, and what they would have to be met over
    CameraRays generate_;
    Kernel spawn_, shade_, accumulate_;
    Levels levels_;
    Surfaces surfaces_;
    Compaction compact_;
    CutRays cut_;
    Buffer<std::uint8_t> alive_;
    Buffer<Spectrum> contributions_;
    Buffer<uint> refused_;
    Buffer<Ray> no_rays_;  ///< these stand for arrays that the scene does without
    Buffer<Spectrum> no_spectra_;
    std::optional<AskedLights> asked_;
    std::optional<Observation> observation_;  ///< only where a batch is observed,
    std::optional<Kernel> describe_;          ///< and explained
};

}  // namespace

std::unique_ptr<Integrator> make_path(const IntegratorJob &job) { return std::make_unique<PathIntegrator>(job); }

}  // namespace brandung
