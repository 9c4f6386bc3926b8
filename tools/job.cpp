#include "tools/job.h"

#include <fmt/core.h>

#include <cstring>

#include "runtime/selftest/trust.h"
#include "scene/view.h"

namespace brandung {
namespace {

Device select_device(const SceneOptions &options, const JobWatch &watch) {
    Device device = Device::select(options.device, options.threads);
    device.on_build(watch.on_build), device.on_built(watch.on_built), device.on_launch(watch.on_launch);
    return device;
}

/// What `auto` takes, if the scene asks for it. It has the device to itself, so that what it launches counts for no render.
std::optional<AcceleratorChoice> choose(const Scene &scene, const CameraDescription &camera, const SceneOptions &options, const JobWatch &watch) {
    if (scene.accelerator != "auto") return {};
    Device device = Device::select(options.device, options.threads);
    return choose_accelerator(device, scene, camera, options.batch, {watch.on_trial, watch.on_accelerator});
}

CompileOptions compile_options(const Device &device, const std::optional<AcceleratorChoice> &choice, const JobWatch &watch) {
    return {.accelerator = choice ? choice->trials.front().kind : nullptr, .watch = watch.on_accelerator, .limit = limit_of(device)};
}

}  // namespace

std::string check_trust(const DeviceInfo &device, bool take_it_all_the_same) {
    const Trust trust = known_trust(device);
    if (!trust.warning.empty()) fmt::print(stderr, "warning: {}\n", trust.warning);
    if (trust.why_not.empty()) return "";
    const std::string text = fmt::format("'{}' has failed brandung selftest: {}", device.name, trust.why_not);
    if (!take_it_all_the_same) throw Error(text + "; --untrusted-device takes it all the same");
    fmt::print(stderr, "warning: {}\n", text);
    return trust.why_not;
}

Job::Job(const Scene &scene, const SceneOptions &options, JobWatch watch, const StopRules &stop)
    : scene(scene),
      camera(chosen_camera(scene, options.camera)),
      device(timed(seconds.device, [&] { return select_device(options, watch); })),
      distrust(check_trust(device.info(), options.untrusted_device)),
      choice(timed(seconds.choice, [&] { return choose(scene, camera, options, watch); })),
      compiled(timed(seconds.scene, [&] { return compile(scene, compile_options(device, choice, watch)); })),
      on_device(timed(seconds.device, [&] { return DeviceScene(device, compiled); })),
      film(timed(seconds.kernels, [&] { return Film(device, scene.film); })),
      aovs(timed(seconds.kernels,
                 [&] {
                     std::optional<Aovs> aovs;
                     if (!scene.film.aovs.empty()) aovs.emplace(device, scene, compiled, on_device, camera, options.batch);
                     return aovs;
                 })),
      renderer(timed(seconds.kernels, [&] {
          return Renderer(device, scene, compiled, on_device, camera, {options.batch, std::move(watch.on_step), stop});
      })) {
    seconds.accelerator = compiled.accelerator_seconds;
    seconds.scene -= seconds.accelerator;
}

void Job::turn(double angle) {
    const CameraDescription turned_camera = turned(camera, angle);
    renderer.look_from(turned_camera);
    if (aovs) aovs->begin(turned_camera);
    if (!scene.headlight) return;
    Light light = scene.lights[*scene.headlight];
    vec3 position;
    std::memcpy(&position, light.words, sizeof position);
    position = turned(position, camera, angle);
    std::memcpy(light.words, &position, sizeof position);
    on_device.write_light(*scene.headlight, light);
}

}  // namespace brandung
