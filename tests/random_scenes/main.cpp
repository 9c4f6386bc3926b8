/// random_scenes SEED: writes the scene file of this seed to standard output.
/// random_scenes FIRST COUNT [specialised]: tries the scenes of these seeds, and writes to standard output a line for each fault, and one of the
/// whole. Exit status 1 if there is any. A scene that takes longer than 20 s beside compilation, or ends the program, is named in the last line of
/// the file random_scenes.seed.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "scene/error.h"
#include "tests/support/probe.h"
#include "tests/support/random_scenes/random_scene.h"
#include "tests/support/random_scenes/trial.h"

namespace {

using namespace brandung;

constexpr uint seconds_per_scene = 20, seconds_to_compile = 300;

struct Outcome {
    std::uint64_t tried = 0, refused = 0, faulty = 0;
};

void try_seed(std::uint64_t seed, bool specialised, Outcome &outcome) {
    std::ofstream("random_scenes.seed") << seed << '\n';
    alarm(seconds_per_scene);  // ends the program by SIGALRM
    ++outcome.tried;
    try {
        Scene scene = read_random_scene(seed);
        Scene scaled = read_random_scene(seed, 0x1p10);
        const std::vector<std::string> faults = faults_of(scene, specialised, is_scalable(scene) ? &scaled : nullptr);
        outcome.faulty += !faults.empty();
        for (const std::string &fault : faults) fmt::print("seed {}: {}\n", seed, fault);
    } catch (const SceneError &error) {
        ++outcome.refused;
        fmt::print(stderr, "seed {} is refused: {}\n", seed, error.what());
    } catch (const std::exception &error) {
        ++outcome.faulty;
        fmt::print("seed {}: {}\n", seed, error.what());
    }
    alarm(0);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char **argv) {
    if (argc < 2 || argc > 4) {
        fmt::print(stderr, "random_scenes SEED, or random_scenes FIRST COUNT [specialised]\n");
        return 2;
    }
    const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
    if (argc == 2) {
        fmt::print("{}\n", random_scene(first).dump(1));
        return 0;
    }
    const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome;
    test_device().on_build([](const std::string &) { alarm(seconds_to_compile); });
    for (std::uint64_t seed = first; seed < first + count; ++seed) try_seed(seed, argc == 4, outcome);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{} scenes, {} refused, {} with faults; {:.1f} s, {:.1f} scenes/s\n", outcome.tried, outcome.refused, outcome.faulty, seconds,
               static_cast<double>(outcome.tried) / seconds);
    return outcome.faulty > 0;
}
