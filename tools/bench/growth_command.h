/// brandung bench growth: accelerators on scenes of more and more objects.
#pragma once

namespace CLI {
class App;
}

namespace brandung {

/// `bench` is the command that it belongs to.
void add_bench_growth(CLI::App &bench, int &status);

}  // namespace brandung
