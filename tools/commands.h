/// The subcommands: each adds its options to the program and sets the exit status when it runs.
#pragma once

namespace CLI {
class App;
}

namespace brandung {

void add_render(CLI::App &app, int &status);
void add_info(CLI::App &app, int &status);
void add_check(CLI::App &app, int &status);
void add_inspect(CLI::App &app, int &status);
void add_devices(CLI::App &app, int &status);
void add_compare(CLI::App &app, int &status);
void add_selftest(CLI::App &app, int &status);
void add_bench(CLI::App &app, int &status);
void add_converge(CLI::App &app, int &status);

}  // namespace brandung
