/// A line on standard error that says how far a render is.
#pragma once
#include <chrono>
#include <string>

#include "tools/pace.h"

namespace brandung {

class ProgressLine {
public:
    explicit ProgressLine(bool quiet);
    /// What is being prepared; a terminal shows it until something else is shown.
    void say(const std::string &what);
    void show(const RenderProgress &progress);
    /// Clears the line, so that messages can follow.
    void clear();

private:
    bool quiet_, terminal_;
    Pace pace_;
    std::chrono::steady_clock::time_point shown_;
};

}  // namespace brandung
