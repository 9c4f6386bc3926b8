/// brandung bench accelerators: all accelerators on the rays of scenes.
#pragma once

namespace CLI {
class App;
}

namespace brandung {

/// `bench` is the command that it belongs to.
void add_bench_accelerators(CLI::App &bench, int &status);

}  // namespace brandung
