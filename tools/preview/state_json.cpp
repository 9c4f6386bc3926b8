#include "tools/preview/state_json.h"

#include "tools/report.h"

namespace brandung {
namespace {

using nlohmann::json;

json number_or_null(const std::optional<double> &number) { return number ? json(*number) : json(nullptr); }
json text_or_null(const std::string &text) { return text.empty() ? json(nullptr) : json(text); }

/// {"batch": 32768, "steps": [[generation, count, [waiting, ...]], ...]}
json queues(const PreviewState &state) {
    json steps = json::array();
    for (const WaveStep &step : state.steps) steps.push_back({step.generation, step.count, step.waiting});
    return {{"batch", state.subject.batch}, {"steps", std::move(steps)}};
}

}  // namespace

const char *phase_name(PreviewPhase phase) {
    const char *const names[] = {"preparing", "rendering", "done", "interrupted", "failed"};
    return names[static_cast<int>(phase)];
}

json state_json(const PreviewState &state) {
    const PreviewSubject &subject = state.subject;
    return {{"scene", subject.scene},
            {"integrator", subject.integrator},
            {"accelerator", text_or_null(subject.accelerator)},
            {"device", text_or_null(subject.device)},
            {"width", subject.width},
            {"height", subject.height},
            {"spp", subject.spp},
            {"exposure", subject.style.exposure},
            {"phase", phase_name(state.phase)},
            {"doing", text_or_null(state.doing)},
            {"part", state.progress.part},
            {"samples_done", state.progress.samples_done},
            {"samples_total", state.progress.samples_total},
            {"seconds", state.progress.seconds},
            {"samples_per_second", number_or_null(state.samples_per_second)},
            {"rays_per_second", number_or_null(state.rays_per_second)},
            {"seconds_left", number_or_null(state.seconds_left)},
            {"noise", noise_statistics(state.progress.noise)},
            {"rays", ray_statistics(state.rays)},
            {"kernels", kernel_statistics(state.kernels)},
            {"queues", queues(state)}};
}

}  // namespace brandung
