#include "tools/progress.h"

#include <fmt/core.h>
#include <unistd.h>

namespace brandung {
namespace {

constexpr int bar_width = 30;

std::string duration(double seconds) {
    const auto whole = static_cast<std::uint64_t>(seconds + 0.5);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

/// The speed is that since `first`, which is nothing or the end of the first batch: until then kernels are compiled.
std::string line_for(const RenderProgress &first, const RenderProgress &progress) {
    const double part = static_cast<double>(progress.samples_done) / static_cast<double>(progress.samples_total);
    const std::string done(static_cast<std::size_t>(part * bar_width), '#'), bar = fmt::format("[{:<30}] {:3.0f} %", done, 100 * part);
    const double samples = static_cast<double>(progress.samples_done - first.samples_done), seconds = progress.seconds - first.seconds;
    if (!(samples > 0 && seconds > 0)) return bar;
    const double left = static_cast<double>(progress.samples_total - progress.samples_done) * seconds / samples;
    return fmt::format("{}  {:.2f} M samples/s  {} left", bar, samples * 1e-6 / seconds, duration(left));
}

}  // namespace

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressLine::say(const std::string &what) {
    if (quiet_ || !terminal_) return;
    fmt::print(stderr, "\r\033[K{}", what);
    std::fflush(stderr);
}

/// On a terminal ten times a second on one line, else a line every five seconds; the end always.
void ProgressLine::show(const RenderProgress &progress) {
    const auto now = std::chrono::steady_clock::now();
    const bool last = progress.samples_done == progress.samples_total;
    if (first_.samples_done == 0 && !last) first_ = progress;
    if (quiet_ || (!last && now - shown_ < std::chrono::milliseconds(terminal_ ? 100 : 5000))) return;
    shown_ = now;
    fmt::print(stderr, "{}{}{}", terminal_ ? "\r\033[K" : "", line_for(first_, progress), terminal_ ? "" : "\n");
    std::fflush(stderr);
}

void ProgressLine::show_reading(const std::string &file, double part) {
    const auto now = std::chrono::steady_clock::now();
    if (now - start_ < std::chrono::seconds(1) || now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    say(fmt::format("reading {}: {:.0f} %", file, 100 * part));
}

void ProgressLine::clear() {
    if (!quiet_ && terminal_) fmt::print(stderr, "\r\033[K");
}

}  // namespace brandung
