#include "runtime/integrators/camera_rays.h"

#include "runtime/wavefront/aovs.h"

namespace brandung {
namespace {

Sources lists_with(const CameraKind &camera, bool moves, Sources lists) {
    lists["generated/camera.cl"] = std::string("#include \"kernels/cameras/") + camera.name + ".cl\"\n";
    if (moves) lists["generated/shutter.cl"] = "#include \"kernels/cameras/shutter.cl\"\n";
    return lists;
}

}  // namespace

CameraRays::CameraRays(const IntegratorJob &job)
    : filter_(job.filter),
      generate_(job.device, "kernels/stages/generate_camera_rays.cl", "generate_camera_rays",
                lists_with(job.camera, job.camera_moves, job.on_device.lists())),
      place_words_(job.compiled.place_words()),
      seen_(job.device, job.camera.sees_everywhere ? 0 : job.batch) {
    if (!job.camera.sees_everywhere) compact_.emplace(job.device, job.batch, 1);
}

void CameraRays::operator()(const Batch &batch, Level &first, Buffer<Sample> &samples) {
    generate_(batch.count(), batch.camera, batch.shutter, shared(batch.camera_motion), batch.params, filter_,
              several(batch.pixels, 1.0 / batch.params.samples), batch.count(), first.rays, several(first.sources, place_words_), first.paths,
              first.live, seen_, samples);
    if (!compact_) return;
    (*compact_)(seen_, batch.count(), batch.count(), 1, 0, 0, first.live);
    first.end = compact_->counts().read().at(0);
    if (batch.aovs) batch.aovs->clear_values();
}

}  // namespace brandung
