/// brandung bench volumes: what the tests of bounding volumes cost.
#pragma once

namespace CLI {
class App;
}

namespace brandung {

/// `bench` is the command that it belongs to.
void add_bench_volumes(CLI::App &bench, int &status);

}  // namespace brandung
