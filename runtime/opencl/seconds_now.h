/// The clock that all durations are measured by.
#pragma once
#include <chrono>

namespace brandung {

/// Seconds of the host's steady clock, from some beginning on.
inline double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace brandung
