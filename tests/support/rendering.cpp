#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include "tests/support/probe.h"

namespace brandung {

__int128 value_of(Integer128 x) { return static_cast<__int128>(static_cast<unsigned __int128>(x.high) << 64 | x.low); }

__int128 sum_of(const FilmPixel &pixel, std::size_t c) { return value_of(pixel.sums[0][c]) + value_of(pixel.sums[1][c]); }

__int128 squares_of(const FilmPixel &pixel, std::size_t c) { return value_of(pixel.squares[0][c]) + value_of(pixel.squares[1][c]); }

Rendering render_scene(const Scene &scene, const RenderOptions &options, Kinds kinds) { return render_scene(test_device(), scene, options, kinds); }

Rendering render_scene(Device &device, const Scene &scene, const RenderOptions &options, Kinds kinds) {
    const CompiledScene compiled = compile(scene, {.kinds = kinds});
    const DeviceScene on_device(device, compiled);
    Film film(device, scene.film);
    Renderer renderer(device, scene, compiled, on_device, scene.cameras.at(0), options);
    if (const RenderEnd end = renderer.render(film); !end.failure.empty()) throw Error(end.failure);
    return {film.read(),   film.develop(), renderer.integrator().counts(), renderer.integrator().refused(), renderer.integrator().media_lost(),
            film.clamped()};
}

std::uint64_t film_hash(const std::vector<FilmPixel> &film) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const std::byte byte : std::as_bytes(std::span(film))) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
    return hash;
}

void expect_same_bits(Scene &scene) {
    const std::uint64_t hash = film_hash(render_scene(scene).film);
    EXPECT_EQ(film_hash(render_scene(scene, {.batch = 1000}).film), hash);
    EXPECT_EQ(film_hash(render_scene(scene, {}, Kinds::all).film), hash);
    for (const char *accelerator : {"none", "kd_tree"}) {
        scene.accelerator = accelerator;
        EXPECT_EQ(film_hash(render_scene(scene).film), hash) << accelerator;
    }
}

}  // namespace brandung
