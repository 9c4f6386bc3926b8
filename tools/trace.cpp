#include "tools/trace.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scene/output.h"
#include "tools/job.h"

namespace brandung {
namespace {

const char *const ray_names[RAY_KINDS] = {"camera", "reflected", "refracted", "shadow"};
const char *const track_names[] = {"phases", "builds of kernels", "launches"};

std::string quoted_json(const std::string &text) { return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

/// Names of the process and its tracks.
std::string tracks(const std::string &title) {
    std::string text = fmt::format(R"({{"ph":"M","pid":1,"name":"process_name","args":{{"name":{}}}}})", quoted_json(title));
    for (int track = 0; track < 3; ++track)
        text += fmt::format(
            ",\n"
            R"({{"ph":"M","pid":1,"tid":{},"name":"thread_name","args":{{"name":"{}"}}}})",
            track + 1, track_names[track]);
    return text;
}

double microseconds(double seconds) { return seconds * 1e6; }

}  // namespace

void Trace::add(Track track, const std::string &name, std::uint64_t items, double start, double end) {
    const uint number = names_.try_emplace(name, static_cast<uint>(names_.size())).first->second;
    events_.push_back({track, number, items, start, end});
}

void Trace::add(const WaveStep &step) { waiting_.push_back({seconds_now(), step.waiting}); }

void Trace::add(const RayCounts &counts) {
    const double now = seconds_now();
    Speed speed{counted_ == 0 ? now : counted_, {}};
    for (std::size_t kind = 0; kind < RAY_KINDS && counted_ > 0; ++kind)
        speed.rays_per_second[kind] = static_cast<double>(counts.rays[kind] - counts_.rays[kind]) / (now - counted_);
    if (counted_ > 0) speeds_.push_back(speed);
    counts_ = counts, counted_ = now;
}

void Trace::write(const std::string &file, const std::string &title) const {
    std::vector<const std::string *> names(names_.size());
    for (const auto &[name, number] : names_) names[number] = &name;
    double first = events_.empty() ? 0 : events_.front().start;
    for (const Event &event : events_) first = std::min(first, event.start);
    const auto time = [&](double seconds) { return microseconds(seconds - first); };

    std::string text = "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n" + tracks(title);
    const auto append = std::back_inserter(text);
    for (const Event &event : events_) {
        fmt::format_to(append,
                       ",\n"
                       R"({{"ph":"X","pid":1,"tid":{},"name":"{}","ts":{:.3f},"dur":{:.3f})",
                       int(event.track) + 1, *names[event.name], time(event.start), microseconds(event.end - event.start));
        if (event.track == launches) fmt::format_to(append, R"(,"args":{{"items":{}}})", event.items);
        text += '}';
    }
    for (const Waiting &waiting : waiting_) {
        fmt::format_to(append,
                       ",\n"
                       R"({{"ph":"C","pid":1,"name":"waiting rays","ts":{:.3f},"args":{{)",
                       time(waiting.time));
        for (std::size_t g = 0; g < waiting.rays.size(); ++g) fmt::format_to(append, R"({}"depth {}":{})", g ? "," : "", g + 1, waiting.rays[g]);
        text += "}}";
    }
    for (const Speed &speed : speeds_) {
        fmt::format_to(append,
                       ",\n"
                       R"({{"ph":"C","pid":1,"name":"rays per second","ts":{:.3f},"args":{{)",
                       time(speed.time));
        for (std::size_t kind = 0; kind < RAY_KINDS; ++kind)
            fmt::format_to(append, R"({}"{}":{:.0f})", kind ? "," : "", ray_names[kind], speed.rays_per_second[kind]);
        text += "}}";
    }
    write_text(file, text + "\n]}\n");
}

}  // namespace brandung
