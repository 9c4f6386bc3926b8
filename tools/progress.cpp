#include "tools/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include "scene/accelerators/accelerator.h"

namespace brandung {
namespace {

constexpr int bar_width = 30;

std::string duration(double seconds) {
    const auto whole = static_cast<std::uint64_t>(seconds + 0.5);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string line_for(const Pace &pace, const RenderProgress &progress) {
    const std::string done(static_cast<std::size_t>(progress.part * bar_width), '#');
    std::string line = fmt::format("[{:<30}] {:3.0f} %", done, 100 * progress.part);
    if (const auto speed = pace.samples_per_second()) line += fmt::format("  {:.2f} M samples/s", *speed * 1e-6);
    if (const auto &noise = progress.noise) line += fmt::format("  noise {:.2g} ({:.2g} to {:.2g})", noise->relmse, noise->low, noise->high);
    if (const auto left = pace.seconds_left()) line += fmt::format("  {} left", duration(*left));
    return line;
}

}  // namespace

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressLine::say(const std::string &what) {
    if (quiet_ || !terminal_) return;
    fmt::print(stderr, "\r\033[K{}", what);
    std::fflush(stderr);
}

/// On a terminal ten times a second on one line, else a line every five seconds.
bool ProgressLine::is_due() {
    const auto now = std::chrono::steady_clock::now();
    if (now - shown_ < std::chrono::milliseconds(terminal_ ? 100 : 5000)) return false;
    shown_ = now;
    return true;
}

void ProgressLine::report(const std::string &what) {
    if (quiet_ || !is_due()) return;
    if (terminal_) return say(what);
    fmt::print(stderr, "{}\n", what);
}

/// The end always.
void ProgressLine::show(const RenderProgress &progress) {
    const bool last = progress.samples_done == progress.samples_total;
    pace_.add(progress);
    if (quiet_ || !(is_due() || last)) return;
    fmt::print(stderr, "{}{}{}", terminal_ ? "\r\033[K" : "", line_for(pace_, progress), terminal_ ? "" : "\n");
    std::fflush(stderr);
}

void ProgressLine::show_preparing(const std::string &what, double part) {
    const auto now = std::chrono::steady_clock::now();
    if (now - start_ < std::chrono::seconds(1) || now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    say(fmt::format("{}: {:.0f} %", what, 100 * part));
}

void ProgressLine::show_building(const AcceleratorKind &kind, double part) { show_preparing(fmt::format("building {}", kind.name), part); }

void ProgressLine::clear() {
    if (!quiet_ && terminal_) fmt::print(stderr, "\r\033[K");
}

}  // namespace brandung
