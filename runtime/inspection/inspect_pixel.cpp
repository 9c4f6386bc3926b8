#include "runtime/inspection/inspect_pixel.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/inspection/describe_hits.h"
#include "runtime/inspection/list_faces.h"
#include "runtime/opencl/error.h"

namespace brandung {
namespace {

void inspect_samples(const InspectedRender &render, uint x, uint y, SampleRange range, std::vector<InspectedSample> &samples) {
    RayTrees trees(range.count);
    const std::vector<Sample> weighed = render.renderer.render_pixel(render.film, x, y, range.first, range.count, &trees);
    for (uint i = 0; i < range.count; ++i)
        if (trees.trees()[i].path.depth == 0)
            throw Error(fmt::format("sample {} of pixel {},{} lies outside of what the camera sees: it has no ray", range.first + i, x, y));
    describe_hits(render.device, render.on_device, trees.trees());
    list_faces(render.device, render.on_device, trees.trees());
    for (uint i = 0; i < range.count; ++i) samples.push_back({range.first + i, std::move(trees.trees()[i]), trees.sums()[i], weighed[i]});
}

}  // namespace

InspectedPixel inspect_pixel(const InspectedRender &render, uint x, uint y, SampleRange kept) {
    InspectedPixel pixel;
    const uint end = kept.first + kept.count;
    for (uint first = 0; first < render.spp;) {
        const bool inside = first >= kept.first && first < end;
        const uint stop = first < kept.first ? kept.first : inside ? end : render.spp, count = std::min(stop - first, render.batch);
        if (inside) {
            inspect_samples(render, x, y, {first, count}, pixel.samples);
        } else {
            render.renderer.render_pixel(render.film, x, y, first, count, nullptr);
        }
        first += count;
    }
    const Window &window = render.film.window();
    const std::size_t place = std::size_t{y - window.top} * window.width() + (x - window.left);
    pixel.film = render.film.read()[place];
    pixel.radiance = render.film.develop()[place];
    return pixel;
}

}  // namespace brandung
