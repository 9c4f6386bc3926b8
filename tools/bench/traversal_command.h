/// brandung bench traversal: the kernels that trace rays, beside Embree.
#pragma once

namespace CLI {
class App;
}

namespace brandung {

void add_bench_traversal(CLI::App &bench, int &status);

}  // namespace brandung
