#include "runtime/integrators/surfaces.h"

#include <algorithm>

#include "runtime/wavefront/aovs.h"

namespace brandung {

Surfaces::Surfaces(const IntegratorJob &job, bool bounces, std::size_t tallies)
    : place_words(job.compiled.place_words()),
      hits(job.device, job.batch),
      hit_instances(job.device, std::size_t{job.batch} * place_words),
      points(job.device, job.batch),
      interfaces(job.device, job.batch),
      directions(job.device, job.batch),
      no_bytes(job.device, 0),
      no_words(job.device, 0),
      no_floats(job.device, 0),
      no_tints(job.device, 0),
      counter(job.device, tallies),
      scene_(job.on_device),
      interior_size_(job.compiled.interior_size),
      paths_(job.compiled.paths),
      several_kinds_(job.compiled.groups_hits()),
      evaluate_(job.device, "kernels/stages/evaluate_surfaces.cl", "evaluate_surfaces", scene_.lists()),
      intersect_together_(tracing_kernel(job, true, &Traversal::closest_hit)) {
    if (bounces) intersect_apart_.emplace(tracing_kernel(job, false, &Traversal::closest_hit));
    if (job.compiled.transmits) media.emplace(job);
    if (job.compiled.chooses) choices.emplace(job);
    if (several_kinds_ && job.device.info().cpu) grouping.emplace(job);
    if (job.compiled.tints) pictures.emplace(job);
}

void Surfaces::start(Level &first, const Batch &batch) {
    if (place_words > 0) first.sources.fill_zero();
    if (!media) return;
    if (std::all_of(batch.interior.begin(), batch.interior.end(), [](uint entry) { return entry == 0; })) return first.interiors.fill_zero();
    std::vector<uint> interiors;
    for (uint i = 0; i < batch.count(); ++i) interiors.insert(interiors.end(), batch.interior.begin(), batch.interior.end());
    first.interiors.write(interiors);
}

void Surfaces::trace(const Wave &wave) {
    Kernel &intersect = stay_together(wave) ? intersect_together_ : *intersect_apart_;
    intersect(wave.count, scene_, wave, wave.level.rays, in_places(wave.level.sources), hits, places(), media ? media->crowded : no_bytes,
              shared(counter.tallies()));
    if (!media) return;
    media->find(wave.count, scene_, wave, wave.level.rays, in_places(wave.level.sources), hits, places(), media->crowded,
                in_lists(wave.level.interiors), in_lists(media->beyond), media->etas, shared(media->lost), shared(counter.tallies()));
}

void Surfaces::find(const Wave &wave, const Batch &batch) {
    trace(wave);
    const Buffer<float> &etas = media ? media->etas : no_floats;
    if (choices)
        choices->choose(wave.count, scene_, shared(scene_.texels()), wave, wave.level.rays, wave.level.paths, hits, places(), updated(etas),
                        choices->chosen);
    if (grouping)
        grouping->group(wave.count, scene_, updated(wave.level.live), wave.first, wave.count, updated(hits), places(), in_lists(beyond()),
                        updated(etas), choices ? choices->chosen : no_words);
    evaluate_(wave.count, scene_, wave, wave.level.rays, hits, places(), etas, choices ? choices->chosen : no_words, points, interfaces, directions);
    if (pictures) pictures->look_up(wave.count, scene_, shared(scene_.texels()), wave, wave.level.rays, hits, places(), points, pictures->tints);
    if (batch.aovs && wave.generation == 0) batch.aovs->record(batch, scene_, wave, hits, hit_instances, points, tints());
}

std::size_t Surfaces::bytes() const {
    return hits.bytes() + hit_instances.bytes() + points.bytes() + interfaces.bytes() + directions.bytes() + counter.bytes() +
           (media ? media->bytes() : 0) + (choices ? choices->chosen.bytes() : 0) + (pictures ? pictures->tints.bytes() : 0);
}

void Surfaces::add_skipped(std::vector<Skipped> &skipped) const {
    if (!media) skipped.push_back({"find_interfaces", "no material transmits: refracted rays and lists of media are not stored"});
    if (!choices) skipped.push_back({"choose_materials", "no material chooses among others"});
    if (paths_ && !grouping)
        skipped.push_back({"group_hits", several_kinds_ ? "only processors take hits in chunks" : "all surfaces scatter light by one kind of BSDF"});
    if (!pictures) skipped.push_back({"look_up_textures", "there are no pictures on surfaces or as background, and no vertex colours"});
}

}  // namespace brandung
