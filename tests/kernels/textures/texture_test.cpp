/// Colours of pictures between their texels.
#include "kernels/textures/texture.h"

#include <gtest/gtest.h>

#include <glm/gtc/packing.hpp>
#include <numeric>

#include "scene/textures/texture.h"
#include "tests/support/probe.h"

namespace brandung {
namespace {

const Spectrum red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), white(1);

/// Of a picture whose rows, from the top, are red, green and blue, white.
std::vector<Spectrum> colors_at(const std::vector<vec2> &places, uint flags) {
    std::vector<Texel> texels(1);  // another picture of one texel comes first
    for (const Spectrum &color : {red, green, blue, white}) texels.push_back(texel_of(color));
    static Probe probe(R"(#include "kernels/textures/texture.cl"
        kernel void probe(const global Texel *texels, const global TextureRecord *texture, const global vec2 *uv, global Spectrum *color) {
            const uint i = get_global_id(0);
            color[i] = texture_color(texels, *texture, uv[i]);
        })");
    std::vector<Spectrum> colors = probe.run<Spectrum>(texels, TextureRecord{1, 2, 2, flags}, places);
    colors.resize(places.size());
    return colors;
}

TEST(Texture, VGrowsUpwardsAndTexelsHaveTheirColoursInTheirMiddles) {
    EXPECT_EQ(colors_at({{0.25f, 0.75f}, {0.75f, 0.75f}, {0.25f, 0.25f}, {0.75f, 0.25f}}, 0), (std::vector<Spectrum>{red, green, blue, white}));
}

TEST(Texture, ColoursBetweenMiddlesAreBilinear) {
    // A quarter of the way from red to green, and below it from blue to white: a mean of 3 : 1.
    const Spectrum above = (red * 3.0f + green) / 4.0f, below = (blue * 3.0f + white) / 4.0f;
    EXPECT_EQ(colors_at({{0.5f, 0.75f}, {0.5f, 0.5f}, {0.375f, 0.75f}, {0.375f, 0.625f}}, 0),
              (std::vector<Spectrum>{(red + green) / 2.0f, Spectrum(0.5f), above, (above * 3.0f + below) / 4.0f}));
}

TEST(Texture, RepeatedPicturesMixAcrossTheirEdges) {
    const Spectrum top = (red + green) / 2.0f, all(0.5f);
    EXPECT_EQ(colors_at({{0, 0.75f}, {1, 0.75f}, {0, 0}, {1, 1}, {-0.25f, 0.75f}, {1.25f, 0.75f}, {0.25f, 1.25f}, {-7.75f, 1024.75f}}, 0),
              (std::vector<Spectrum>{top, top, all, all, green, red, blue, red}));
}

// A quarter of the way from the last texel's middle, at 3/4, to the first's, at 5/4: v grows upwards, so that the last row's is at 1/4.
TEST(Texture, RepeatedPicturesMixTheLastTexelWithTheFirst) {
    const Spectrum right = (green * 3.0f + red) / 4.0f, below = (blue * 3.0f + red) / 4.0f;
    const Spectrum corner = (right * 3.0f + (white * 3.0f + blue) / 4.0f) / 4.0f;
    EXPECT_EQ(colors_at({{0.875f, 0.75f}, {0.25f, 0.125f}, {0.875f, 0.625f}, {1.875f, -0.25f}}, 0),
              (std::vector<Spectrum>{right, below, corner, right}));
}

TEST(Texture, ClampedPicturesGoOnAsTheirEdges) {
    EXPECT_EQ(colors_at({{0, 0.75f}, {-3, 7}, {1, 1}, {0.5f, 1}, {9, -9}, {0, 0}}, TEXTURE_CLAMPS_U | TEXTURE_CLAMPS_V),
              (std::vector<Spectrum>{red, red, green, (red + green) / 2.0f, white, blue}));
}

TEST(Texture, PanoramasRepeatToTheSidesOnly) {
    EXPECT_EQ(colors_at({{0, 2}, {1.25f, -1}}, TEXTURE_CLAMPS_V), (std::vector<Spectrum>{(red + green) / 2.0f, blue}));
}

/// Floats near an edge, and huge ones, whose fraction is nothing.
TEST(Texture, NoPlaceLeadsOutOfThePicture) {
    std::vector<vec2> places;
    for (const float x : {-1e-9f, 0x1.fffffep-1f, 1 + 0x1p-23f, -0x1p-149f, 1e15f, -1e15f, 16777215.0f})
        places.push_back({x, x}), places.push_back({x, 0.75f});
    for (const uint flags : {0u, TEXTURE_CLAMPS_U, TEXTURE_CLAMPS_U | TEXTURE_CLAMPS_V})
        for (const Spectrum &color : colors_at(places, flags))
            for (int c = 0; c < 3; ++c) EXPECT_TRUE(color[c] >= 0 && color[c] <= 1) << color[c];
}

TEST(Texture, HalfFloatsAreExact) {
    std::vector<uint> halves(0x7c00);
    std::iota(halves.begin(), halves.end(), 0u);
    const std::vector<float> floats = Probe(R"(#include "kernels/textures/texture.cl"
        kernel void probe(const global uint *bits, global float *value) { value[get_global_id(0)] = float_of_half(bits[get_global_id(0)]); })")
                                          .run<float>(halves);
    for (const uint bits : halves) ASSERT_EQ(floats[bits], glm::unpackHalf1x16(static_cast<std::uint16_t>(bits))) << bits;
}

}  // namespace
}  // namespace brandung
