/// Colours of pictures between their texels: repeated and clamped, at their edges, and where places are much larger than pictures.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "kernels/textures/texture.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/precision.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 16;

struct Pictures {
    std::vector<Texel> texels;
    std::vector<TextureRecord> records;
};

uint any_half(InputSource &source) { return source.one_in(8) ? source.below(0x7c00) : glm::packHalf1x16(source.uniform(0, 1)); }

float channel_of(const Texel &texel, int c) {
    return c < 2 ? glm::unpackHalf2x16(texel.red_green)[c] : glm::unpackHalf1x16(std::uint16_t(texel.blue));
}

/// From one texel to long strips, some of them dark, some with the largest half floats.
Pictures make_pictures(InputSource &source) {
    const std::array<uint, 2> sizes[] = {{1, 1}, {2, 2}, {3, 5}, {64, 64}, {1000, 7}, {1, 4097}};
    Pictures pictures;
    for (const auto [width, height] : sizes) {
        pictures.records.push_back({uint(pictures.texels.size()), width, height, 0});
        for (uint i = 0; i < width * height; ++i) {
            const uint red = any_half(source), green = any_half(source), blue = any_half(source);
            pictures.texels.push_back({red | green << 16, blue});
        }
    }
    return pictures;
}

/// One coordinate: in the picture, at texels' edges and middles and next to them, near 0, or far away.
float any_coordinate(InputSource &source, uint count) {
    const float edge = float(source.below(2 * count + 1)) / float(2 * count), beside = edge + source.sign() * source.power_of_two(-30, -20);
    const float choices[] = {source.uniform(0, 1),
                             edge,
                             beside,
                             source.sign() * source.power_of_two(-149, 0),
                             source.uniform(-4, 4),
                             source.sign() * source.power_of_two(0, 40)};
    return choices[source.below(6)];
}

/// Where a coordinate lies among texels: the one before it, and how far behind its middle.
struct Between {
    std::int64_t first;
    extended weight;
    extended error;  ///< of the place [texels]
};

std::int64_t whole_below(extended x) {
    const auto whole = static_cast<std::int64_t>(x);
    return whole - (x < extended(whole));
}

/// Differences from whole numbers are rounded once, as are the product and the last difference; 1 - v before that.
Between between(extended x, extended x_error, uint count, bool clamps) {
    const extended inside = clamps ? lesser(greater(x, 0), 1) : x - extended(whole_below(x)), place = inside * count - extended(0.5);
    const std::int64_t first = whole_below(place);
    return {first, place - extended(first), (x_error + 4 * unit_roundoff) * count};
}

std::int64_t texel_number(std::int64_t i, uint count, bool clamps) {
    const std::int64_t n = count;
    return clamps ? std::min(std::max(i, std::int64_t{0}), n - 1) : (i % n + n) % n;
}

class Textures final : public Subject {
public:
    explicit Textures(Device &device) : device_(device), kernel_(device, "kernels/selftest/textures.cl", "test_textures") {}

    Findings examine(uint round) override {
        InputSource source(seed_of(12, round, 0));
        const Pictures pictures = make_pictures(source);
        std::vector<TextureRecord> records(inputs_per_round);
        std::vector<vec2> places(inputs_per_round);
        for (std::size_t i = 0; i < inputs_per_round; ++i) {
            records[i] = pictures.records[source.below(uint(pictures.records.size()))];
            records[i].flags = source.below(4);
            places[i] = {any_coordinate(source, records[i].width), any_coordinate(source, records[i].height)};
        }
        const std::vector<vec3> colors = run<float, vec3>(kernel_.in_float, pictures, records, places);
        const auto doubles = kernel_.in_double ? run<double, glm::dvec3>(*kernel_.in_double, pictures, records, places) : std::vector<glm::dvec3>();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) {
            for (int c = 0; c < 3; ++c)
                look_at(pictures, records[i], places[i], c, colors[i][c], kernel_.in_double ? &doubles[i][c] : nullptr, findings);
        });
    }

private:
    template <class Number, class Color>
    std::vector<Color> run(Kernel &kernel, const Pictures &pictures, const std::vector<TextureRecord> &records, const std::vector<vec2> &places) {
        const std::vector<glm::vec<2, Number>> wide(places.begin(), places.end());
        Buffer<Color> colors(device_, places.size());
        kernel(places.size(), Buffer<Texel>(device_, pictures.texels), Buffer<TextureRecord>(device_, records),
               Buffer<glm::vec<2, Number>>(device_, wide), static_cast<uint>(places.size()), colors);
        return colors.read();
    }

    /// Bilinear, and so steady: a place that is off by e texels changes a colour by e times the differences of texels about it, which are at most the
    /// largest of them, along both axes; and each of three means has 3 roundings.
    static void look_at(const Pictures &pictures, const TextureRecord &texture, vec2 place, int c, float color, const double *in_double,
                        Findings &findings) {
        const bool clamps_u = (texture.flags & TEXTURE_CLAMPS_U) != 0, clamps_v = (texture.flags & TEXTURE_CLAMPS_V) != 0;
        const Between column = between(place.x, 0, texture.width, clamps_u);
        const Between row = between(1 - extended(place.y), unit_roundoff * absolute(1 - extended(place.y)), texture.height, clamps_v);
        const auto texel = [&](std::int64_t i, std::int64_t j) {
            const auto at = texel_number(column.first + i, texture.width, clamps_u), down = texel_number(row.first + j, texture.height, clamps_v);
            return extended(channel_of(pictures.texels[texture.offset + std::size_t(down) * texture.width + std::size_t(at)], c));
        };
        const auto across = [&](std::int64_t j) { return texel(0, j) * (1 - column.weight) + texel(1, j) * column.weight; };
        const extended exact = across(0) * (1 - row.weight) + across(1) * row.weight;
        extended largest = 0;
        for (std::int64_t i = -1; i < 3; ++i)
            for (std::int64_t j = -1; j < 3; ++j) largest = greater(largest, texel(i, j));
        const double allowed = double((column.error + row.error) * largest + 9 * unit_roundoff * exact);
        findings.hits += c == 0;
        if (!(column.error < 0.5 && row.error < 0.5)) return findings.leave_out(Quantity::value);  // such floats have no places between texels
        if (in_double) findings.rounding_of(Quantity::value).add(std::abs(color - *in_double), allowed, ulp_of(exact), double(exact));
        findings.measure(Quantity::value, double(absolute(color - exact)), allowed, ulp_of(exact), double(exact), [&] {
            return fmt::format("{:.9g}, and not {:.9g}, of a picture of {} x {}, flags {}, at ({:a}, {:a})", color, double(exact), texture.width,
                               texture.height, texture.flags, place.x, place.y);
        });
    }

    Device &device_;
    KernelInBoth kernel_;
};

}  // namespace

void add_textures(std::vector<SubjectEntry> &list) {
    list.push_back({"textures", "textures/texture.cl", "a place's rounding times the texels about it, and 9 roundings", 2,
                    [](Device &device) { return std::make_unique<Textures>(device); }});
}

}  // namespace brandung
