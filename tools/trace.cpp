#include "tools/trace.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "runtime/opencl/seconds_now.h"

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

}  // namespace

Trace::Trace(const std::string &file, const std::string &title, double start) : text_(file, "\n]}\n"), start_(start) {
    text_.append("{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n" + tracks(title));
}

void Trace::add(Track track, const std::string &name, double start, double end, const std::string &more) {
    text_.append(
        fmt::format(",\n"
                    R"({{"ph":"X","pid":1,"tid":{},"name":"{}","ts":{:.3f},"dur":{:.3f}{}}})",
                    int(track) + 1, name, time(start), (end - start) * 1e6, more));
}

void Trace::add(const Launch &launch) {
    add(launches, launch.kernel, launch.start, launch.end, fmt::format(R"(,"args":{{"items":{}}})", launch.items));
}

void Trace::add(const WaveStep &step) {
    std::string rays;
    for (std::size_t g = 0; g < step.waiting.size(); ++g) rays += fmt::format(R"({}"depth {}":{})", g ? "," : "", g + 1, step.waiting[g]);
    text_.append(
        fmt::format(",\n"
                    R"({{"ph":"C","pid":1,"name":"waiting rays","ts":{:.3f},"args":{{{}}}}})",
                    time(seconds_now()), rays));
}

void Trace::add(const RayCounts &counts) {
    const double now = seconds_now(), before = counted_;
    std::string speeds;
    for (std::size_t kind = 0; kind < RAY_KINDS; ++kind)
        speeds += fmt::format(R"({}"{}":{:.0f})", kind ? "," : "", ray_names[kind],
                              static_cast<double>(counts.rays[kind] - counts_.rays[kind]) / (now - before));
    counts_ = counts, counted_ = now;
    if (before > 0)
        text_.append(
            fmt::format(",\n"
                        R"({{"ph":"C","pid":1,"name":"rays per second","ts":{:.3f},"args":{{{}}}}})",
                        time(before), speeds));
}

}  // namespace brandung
