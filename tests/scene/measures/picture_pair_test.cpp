#include "scene/measures/picture_pair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/error.h"
#include "tests/scene/measures/pictures.h"

namespace brandung {
namespace {

TEST(PicturePair, OfDifferentSizesIsRefused) {
    const Picture a = picture_of(4, 3, waves), b = picture_of(3, 4, waves);
    try {
        pair_pictures(a, b, DynamicRange::hdr);
        FAIL();
    } catch (const SceneError &error) {
        EXPECT_STREQ(error.what(), "pictures of 4 x 3 and 3 x 4 pixels cannot be compared: the sizes differ");
    }
}

TEST(PicturePair, WithoutAnyFinitePixelIsRefused) { EXPECT_THROW(hdr_pair(2, 2, constant(vec3(NAN)), constant(vec3(1))), SceneError); }

TEST(PicturePair, CountsPixelsThatAreNotFinitePerPictureAndTogether) {
    const auto a = [](int x, int, int) { return x < 2 ? NAN : 1.0f; };
    const auto b = [](int x, int, int c) { return x > 0 && x < 3 && c == 1 ? INFINITY : 1.0f; };
    const PicturePair pair = hdr_pair(4, 1, a, b);
    EXPECT_EQ(pair.test_not_finite, 2u);
    EXPECT_EQ(pair.reference_not_finite, 2u);
    EXPECT_EQ(pair.not_finite(), 3u);
    EXPECT_EQ(pair.finite, (std::vector<std::uint8_t>{0, 0, 0, 1}));
    EXPECT_EQ(pair.test[2], vec3(0)) << "both are black where one is not finite";
}

/// 0.5 is 188 of 255 (0.7354) in sRGB; light beyond 0 to 1 isn't shown.
TEST(PicturePair, LdrValuesAreEncodedAndClamped) {
    const PicturePair pair = pair_pictures(picture_of(1, 1, constant({0.5f, -1, 7})), picture_of(1, 1, constant(vec3(1))), DynamicRange::ldr);
    EXPECT_NEAR(pair.test[0].x, 0.735357, 1e-6);
    EXPECT_EQ(pair.test[0].y, 0);
    EXPECT_NEAR(pair.test[0].z, 1, 1e-6);
}

TEST(Srgb, DecodingIsTheInverseOfEncoding) {
    for (int i = 0; i <= 255; ++i) EXPECT_NEAR(srgb_encoded(srgb_decoded(float(i) / 255)), float(i) / 255, 2e-7) << i;
    EXPECT_NEAR(srgb_decoded(0.735357f), 0.5, 1e-6);
    EXPECT_NEAR(srgb_decoded(0.04f), 0.04 / 12.92, 1e-9) << "straight near black";
}

}  // namespace
}  // namespace brandung
