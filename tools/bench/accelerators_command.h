/// brandung bench accelerators: all accelerators on the rays of scenes.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace brandung {

/// `bench` is the command that it belongs to.
void add_bench_accelerators(CLI::App &bench, int &status);
/// These, or all of the list if there are none. Throws SceneError for a name that is none.
std::vector<std::string> chosen_accelerators(const std::vector<std::string> &only);

}  // namespace brandung
