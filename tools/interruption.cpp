#include "tools/interruption.h"

#include <atomic>
#include <csignal>

namespace brandung {
namespace {

std::atomic<bool> interrupted = false;  // set by the signal handler, which may do no more

}  // namespace

void handle_interruptions() {
    struct sigaction action {};
    action.sa_handler = [](int) { interrupted = true; };
    action.sa_flags = SA_RESETHAND;
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

bool is_interrupted() { return interrupted; }

}  // namespace brandung
