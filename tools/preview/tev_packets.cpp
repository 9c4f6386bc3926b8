#include "tools/preview/tev_packets.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace brandung {
namespace {

constexpr uint tile_size = 128;
constexpr const char *channels[] = {"R", "G", "B"};
constexpr int channel_count = 3;
enum PacketType : std::uint8_t { close_image = 2, create_image = 4, update_image = 6 };

class PacketWriter {
public:
    explicit PacketWriter(PacketType type) { integer<std::uint32_t>(0), integer<std::uint8_t>(type); }

    template <class Integer> void integer(Integer value) {
        for (std::size_t byte = 0; byte < sizeof value; ++byte)
            packet_.push_back(static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> (8 * byte)));
    }
    void number(float value) { integer(std::bit_cast<std::uint32_t>(value)); }
    void text(const std::string &text) { packet_.insert(packet_.end(), text.c_str(), text.c_str() + text.size() + 1); }
    void channel_names() {
        integer<std::int32_t>(channel_count);
        for (const char *channel : channels) text(channel);
    }
    /// The packet, which begins with its length.
    Packet finish() {
        const auto length = static_cast<std::uint32_t>(packet_.size());
        for (int byte = 0; byte < 4; ++byte) packet_[byte] = static_cast<unsigned char>(length >> (8 * byte));
        return std::move(packet_);
    }

private:
    Packet packet_;
};

}  // namespace

std::vector<Tile> tiles_of(uint width, uint height) {
    std::vector<Tile> tiles;
    for (uint y = 0; y < height; y += tile_size)
        for (uint x = 0; x < width; x += tile_size) tiles.push_back({x, y, std::min(tile_size, width - x), std::min(tile_size, height - y)});
    return tiles;
}

bool same_tile(const Picture &a, const Picture &b, const Tile &tile) {
    for (uint row = tile.y; row < tile.y + tile.height; ++row) {
        const std::size_t first = std::size_t{row} * a.width + tile.x;
        if (std::memcmp(&a.pixels[first], &b.pixels[first], tile.width * sizeof(vec3)) != 0) return false;
    }
    return true;
}

Packet close_image_packet(const std::string &name) {
    PacketWriter packet(close_image);
    packet.text(name);
    return packet.finish();
}

Packet create_image_packet(const std::string &name, uint width, uint height) {
    PacketWriter packet(create_image);
    packet.integer<std::uint8_t>(true);  // shown at once
    packet.text(name);
    for (const uint size : {width, height}) packet.integer<std::int32_t>(static_cast<std::int32_t>(size));
    packet.channel_names();
    return packet.finish();
}

Packet update_image_packet(const std::string &name, const Picture &picture, const Tile &tile) {
    PacketWriter packet(update_image);
    packet.integer<std::uint8_t>(false);  // another picture that the user looks at stays in front
    packet.text(name);
    packet.channel_names();
    for (const uint place : {tile.x, tile.y, tile.width, tile.height}) packet.integer<std::int32_t>(static_cast<std::int32_t>(place));
    for (int channel = 0; channel < channel_count; ++channel) packet.integer<std::int64_t>(channel);        // where the channel begins
    for (int channel = 0; channel < channel_count; ++channel) packet.integer<std::int64_t>(channel_count);  // from pixel to pixel
    for (uint row = tile.y; row < tile.y + tile.height; ++row)
        for (uint column = tile.x; column < tile.x + tile.width; ++column)
            for (int channel = 0; channel < channel_count; ++channel)
                packet.number(picture.pixels[std::size_t{row} * picture.width + column][channel]);
    return packet.finish();
}

}  // namespace brandung
