#include "tools/converge/climb.h"

#include <fmt/format.h>

#include "scene/formats/limits.h"
#include "tools/interruption.h"

namespace brandung {
namespace {

constexpr uint reference_seed = 0x5eedu;

void check_interruption() {
    if (is_interrupted()) throw Interrupted();
}

/// One picture of one way, and its errors; nothing if that is interrupted.
std::optional<Run> run_once(const Plan &plan, Climber &climber, std::size_t rung, uint repetition, const ReferencePicture &reference,
                            Teller &teller) {
    const Rungs &rungs = plan.rungs;
    const bool by_time = rungs.samples.empty();
    const auto observe = teller.observer(
        fmt::format("{}, rung {} of {}, repetition {} of {}", climber.name(), rung + 1, rungs.count(), repetition + 1, plan.repetitions));
    const StopRules stop{.error = {}, .seconds = by_time ? std::optional(rungs.seconds[rung]) : std::nullopt};
    const uint seed = seed_at(plan.first_seed, repetition + plan.repetitions * static_cast<uint>(rung), reference.seed);
    const Climber::Result result = climber.render(by_time ? max_samples : rungs.samples[rung], seed, stop, observe);
    if (is_interrupted()) return std::nullopt;
    return Run{rung, seed, result.samples, result.seconds, errors_of(result.picture, reference.picture)};
}

}  // namespace

std::function<bool(const RenderProgress &)> Teller::observer(const std::string &what) {
    return [this, what](const RenderProgress &progress) {
        line_.report(fmt::format("{}: {:.0f} %", what, 100 * progress.part));
        return !is_interrupted();
    };
}

void Teller::note(const std::string &text) {
    line_.clear();
    if (!quiet_) fmt::print(stderr, "{}\n", text);
}

void Teller::warn(const std::string &text) {
    line_.clear();
    fmt::print(stderr, "warning: {}\n", text);
}

ReferencePicture render_reference(Climber &climber, uint spp, Teller &teller) {
    const std::string name = fmt::format("{} spp of {}", spp, climber.name());
    teller.note("reference: " + name);
    Climber::Result result = climber.render(spp, reference_seed, {}, teller.observer("reference"));
    check_interruption();
    return {std::move(result.picture), name, result.noise ? std::optional(result.noise->relmse) : std::nullopt, climber.way(), reference_seed};
}

void warm_up(Climber &climber, Teller &teller) {
    climber.render(2, 0, {}, teller.observer("kernels of " + climber.name()));
    check_interruption();
}

std::vector<Series> series_of(const std::vector<std::unique_ptr<Climber>> &climbers) {
    std::vector<Series> all;
    for (const auto &climber : climbers) all.push_back({climber->name(), {}});
    return all;
}

std::vector<Series> climb(const Plan &plan, const std::vector<std::unique_ptr<Climber>> &climbers, const ReferencePicture &reference,
                          Teller &teller) {
    std::vector<Series> all = series_of(climbers);
    for (std::size_t rung = 0; rung < plan.rungs.count(); ++rung) {
        for (uint repetition = 0; repetition < plan.repetitions; ++repetition)
            for (std::size_t i = 0; i < climbers.size(); ++i) {
                const std::optional<Run> run = run_once(plan, *climbers[i], rung, repetition, reference, teller);
                if (!run) return all;
                all[i].runs.push_back(*run);
            }
        teller.note(fmt::format("rung {} of {} is measured", rung + 1, plan.rungs.count()));
    }
    return all;
}

}  // namespace brandung
