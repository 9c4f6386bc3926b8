/// A line on standard error that says how far a render is.
#pragma once
#include <chrono>
#include <string>

#include "tools/pace.h"

namespace brandung {

struct AcceleratorKind;

class ProgressLine {
public:
    explicit ProgressLine(bool quiet);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine &) = delete;
    /// What is being prepared; a terminal shows it until something else is shown.
    void say(const std::string &what);
    void show(const RenderProgress &progress);
    /// How far something else is: as often as show(), at once the first time.
    void report(const std::string &what);
    /// How far what comes before a render is; nothing within the first second.
    void show_reading(const std::string &file, double part) { show_preparing("reading " + file, part); }
    void show_building(const AcceleratorKind &kind, double part);
    /// Clears the line, so that messages can follow.
    void clear();

private:
    bool quiet_, terminal_;
    /// Whether it is time to show something again; then it counts as shown now.
    bool is_due();
    void show_preparing(const std::string &what, double part);

    Pace pace_;
    std::chrono::steady_clock::time_point shown_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace brandung
