/// Interruption by a signal: a render ends with what it has.
#pragma once

namespace brandung {

inline constexpr int interrupted_status = 130;

/// From here on the first signal to interrupt or terminate is noted, and a second one ends the program.
void handle_interruptions();
bool is_interrupted();

}  // namespace brandung
