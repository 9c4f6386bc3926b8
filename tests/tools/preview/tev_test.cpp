/// What tev is told, against a reader of its protocol.
#include "tools/preview/tev.h"

#include <gtest/gtest.h>

#include "scene/error.h"
#include "tests/tools/preview/states.h"
#include "tests/tools/preview/tev_reader.h"
#include "tools/preview/target.h"

namespace brandung {
namespace {

std::vector<float> values_of(const Picture &picture) {
    std::vector<float> values;
    for (const vec3 &pixel : picture.pixels) values.insert(values.end(), {pixel.x, pixel.y, pixel.z});
    return values;
}

/// Until the viewer has sent what it was shown.
void wait_until_sent(const TevViewer &viewer) {
    while (!viewer.wants_picture()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// A length of 4 bytes that counts itself, a type, texts that end with zero, numbers from their lowest byte on.
TEST(TevPackets, AreTheProtocolsBytes) {
    EXPECT_EQ(close_image_packet("ab"), (Packet{8, 0, 0, 0, 2, 'a', 'b', 0}));
    EXPECT_EQ(create_image_packet("a", 300, 2), (Packet{26, 0, 0, 0, 4, 1, 'a', 0, 44, 1, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 'R', 0, 'G', 0, 'B', 0}));
    const Packet update = update_image_packet("a", *test_picture(3, 2, 1), {1, 1, 2, 1});
    // 4 + 1 + 1 + 2 bytes; 4 + 6 of channels; 16 of places; 24 of offsets and 24 of strides; 2 pixels of 12.
    EXPECT_EQ(update.size(), 106u);
    EXPECT_EQ(update[0], 106);
    EXPECT_EQ(Packet(update.end() - 4, update.end()), (Packet{0, 0, 0x80, 0x3f})) << "1.0f, the last pixel's blue";
}

TEST(TevPackets, TilesCoverAPictureOnce) {
    std::vector<int> covered(300 * 140, 0);
    for (const Tile &tile : tiles_of(300, 140))
        for (uint y = tile.y; y < tile.y + tile.height; ++y)
            for (uint x = tile.x; x < tile.x + tile.width; ++x) ++covered.at(y * 300 + x);
    EXPECT_EQ(covered, std::vector<int>(300 * 140, 1));
}

TEST(Tev, HasTheLastPictureToTheBit) {
    TevReader reader;
    const auto last = test_picture(300, 140, -2.5e-40f);
    {
        TevViewer viewer(read_preview_target(reader.target()), "out.exr", 300, 140);
        for (const float value : {1.0f, 7.0f}) {
            EXPECT_TRUE(viewer.wants_picture());
            viewer.show(test_state(test_picture(300, 140, value)));
            wait_until_sent(viewer);
        }
        viewer.show(test_state(last, PreviewPhase::done));
        EXPECT_EQ(viewer.take_fault(), std::nullopt);
    }
    const TevPicture picture = reader.finish();
    EXPECT_EQ(picture.fault, "");
    EXPECT_EQ(picture.name, "out.exr");
    EXPECT_EQ(picture.closed, "out.exr") << "one that an earlier render left is replaced";
    EXPECT_EQ(picture.channels, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(picture.values, values_of(*last));
}

TEST(Tev, IsSentOnlyTheTilesThatChanged) {
    TevReader reader;
    const auto first = test_picture(300, 140, 1);  // six tiles
    Picture second = *first;
    second.pixels[139 * 300 + 299].y = 5;  // in the last of them
    {
        TevViewer viewer(read_preview_target(reader.target()), "a", 300, 140);
        viewer.show(test_state(first));
        wait_until_sent(viewer);
        viewer.show(test_state(first));  // the same again: nothing
        viewer.show(test_state(std::make_shared<const Picture>(second)));
    }
    const TevPicture picture = reader.finish();
    EXPECT_EQ(picture.fault, "");
    EXPECT_EQ(picture.updates, 7);
    EXPECT_EQ(picture.values, values_of(second));
}

TEST(Tev, ThatVanishesIsNamedOnceAndLeftAlone) {
    TevReader reader(100);  // it closes the connection after 100 bytes
    TevViewer viewer(read_preview_target(reader.target()), "a", 300, 140);
    std::optional<std::string> fault;
    for (int i = 0; i < 1000 && !fault; ++i) {
        viewer.show(test_state(test_picture(300, 140, static_cast<float>(i))));
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        fault = viewer.take_fault();
    }
    ASSERT_TRUE(fault.has_value());
    EXPECT_TRUE(fault->starts_with("--preview: tev at 127.0.0.1:" + std::to_string(reader.port()) + " is gone: ")) << *fault;
    EXPECT_EQ(viewer.take_fault(), std::nullopt);
    EXPECT_FALSE(viewer.wants_picture());
    viewer.show(test_state(test_picture(300, 140, 0)));
}

TEST(Tev, WhereNobodyListensIsAnError) {
    const int port = TevReader().port();  // free again
    try {
        TevViewer viewer({PreviewTarget::tev, "127.0.0.1", port}, "a", 3, 2);
        FAIL() << "nobody listens";
    } catch (const SceneError &error) {
        EXPECT_EQ(std::string(error.what()), "--preview: no tev at 127.0.0.1:" + std::to_string(port) + ": Connection refused; start it first");
    }
}

}  // namespace
}  // namespace brandung
