/// What the viewer tev (https://github.com/Tom94/tev) is told over TCP: packets of a length, a type and fields, all little endian.
#pragma once
#include <string>
#include <vector>

#include "scene/image.h"

namespace brandung {

/// A part of a picture, in pixels from the upper left corner.
struct Tile {
    uint x = 0, y = 0, width = 0, height = 0;
};

/// A picture in squares of 128 pixels, smaller ones at its right and lower edges; row by row.
std::vector<Tile> tiles_of(uint width, uint height);
/// Whether two pictures of one size have the same bits there.
bool same_tile(const Picture &a, const Picture &b, const Tile &tile);

using Packet = std::vector<unsigned char>;
Packet close_image_packet(const std::string &name);
/// Opens a black picture with channels R, G, B.
Packet create_image_packet(const std::string &name, uint width, uint height);
Packet update_image_packet(const std::string &name, const Picture &picture, const Tile &tile);

}  // namespace brandung
