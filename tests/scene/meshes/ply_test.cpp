#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/scene/meshes/mesh_folder.h"

namespace brandung {
namespace {

const std::string triangle_header =
    "ply\nformat ascii 1.0\ncomment a triangle\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string triangle_values = "0 0 0\n1 0 0\n0 1 0.5\n3 0 1 2\n";

/// Values as bytes of one order.
class Bytes {
public:
    explicit Bytes(bool big_endian) : swap_(big_endian != (std::endian::native == std::endian::big)) {}
    template <class T> Bytes &add(std::initializer_list<T> values) {
        for (const T value : values) {
            char bytes[sizeof value];
            std::memcpy(bytes, &value, sizeof value);
            for (std::size_t i = 0; i < sizeof value; ++i) text += bytes[swap_ ? sizeof value - 1 - i : i];
        }
        return *this;
    }
    std::string text;

private:
    bool swap_;
};

class Ply : public testing::Test {
protected:
    std::vector<MeshPart> read(const std::string &bytes) { return folder.read("mesh.ply", bytes); }
    std::string error(const std::string &bytes) { return folder.error("mesh.ply", bytes); }
    /// The error of the triangle with `before` replaced by `after` in its text.
    std::string error(const std::string &before, const std::string &after) {
        std::string text = triangle_header + triangle_values;
        text.replace(text.find(before), before.size(), after);
        return error(text);
    }
    std::map<std::string, uint> &warnings() { return folder.scene.warnings; }

    MeshFolder folder;
};

TEST_F(Ply, Text) {
    const auto parts = read(triangle_header + triangle_values);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(corners_of(parts[0]), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f}}));
    EXPECT_EQ(folder.scene.materials.at(parts[0].material).name, "no material");
    EXPECT_TRUE(warnings().empty());
    std::string dos;
    for (const char c : triangle_header + triangle_values) dos += c == '\n' ? "\r\n" : std::string(1, c);
    dos.resize(dos.size() - 2);
    EXPECT_EQ(corners_of(read(dos).at(0)), corners_of(parts[0]));
}

/// Properties of all types, unknown ones and unknown elements between the known.
TEST_F(Ply, BytesOfBothOrders) {
    for (const bool big : {false, true}) {
        const std::string header = std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
                                   " 1.0\nelement camera 2\nproperty short a\nproperty list uint ushort b\nelement vertex 4\nproperty double x\n"
                                   "property float32 y\nproperty list uchar double extra\nproperty float z\nproperty char nx\nproperty short ny\n"
                                   "property int nz\nproperty float s\nproperty float t\nelement face 2\nproperty uint16 flags\n"
                                   "property list int8 uint32 vertex_index\nelement edge 1\nproperty int v\nend_header\n";
        Bytes bytes(big);
        bytes.add<std::int16_t>({-5}).add<std::uint32_t>({2}).add<std::uint16_t>({1, 2}).add<std::int16_t>({7}).add<std::uint32_t>({0});
        for (int i = 0; i < 4; ++i) {
            bytes.add<double>({i % 2 + 0.5}).add<float>({float(i / 2)}).add<std::uint8_t>({1}).add<double>({9}).add<float>({-2});
            bytes.add<std::int8_t>({0}).add<std::int16_t>({-3}).add<std::int32_t>({4}).add<float>({0.25f * float(i), 1});
        }
        bytes.add<std::uint16_t>({1}).add<std::int8_t>({4}).add<std::uint32_t>({0, 1, 3, 2});
        bytes.add<std::uint16_t>({2}).add<std::int8_t>({3}).add<std::uint32_t>({2, 1, 0}).add<std::int32_t>({1});
        const auto parts = read(header + bytes.text);
        ASSERT_EQ(parts.size(), 1u);
        const MeshData &mesh = parts[0].mesh;
        EXPECT_EQ(mesh.indices.size(), 9u);
        EXPECT_EQ(corners_of(parts[0])[6], vec3(0.5f, 1, -2));
        EXPECT_EQ(mesh.normals.at(3), vec3(0, -0.6f, 0.8f));
        EXPECT_EQ(mesh.uvs.at(mesh.indices[6]), vec2(0.5f, 1));
        EXPECT_TRUE(warnings().empty());
        EXPECT_EQ(error(header + bytes.text.substr(0, bytes.text.size() - 5)).find("mesh.ply: byte "), 0u);
    }
}

TEST_F(Ply, FacesMayHaveTextureCoordinatesOfTheirOwn) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
        "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1\n3 0 1 2 6 0.5 0 1 0 0 1\n";
    const auto parts = read(text);
    ASSERT_EQ(parts.size(), 1u);
    const MeshData &mesh = parts[0].mesh;
    EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
    EXPECT_EQ(mesh.uvs.at(mesh.indices[1]), vec2(1, 0));
    EXPECT_EQ(mesh.uvs.at(mesh.indices[3]), vec2(0.5f, 0));
}

/// Whole numbers are sRGB (128 / 255 is 0.2159 in linear light), floats linear.
TEST_F(Ply, ColoursAndTheTextureOfAComment) {
    for (const bool whole : {true, false}) {
        const std::string type = whole ? "uchar" : "float", half = whole ? "128" : "0.5";
        const std::string text =
            "ply\nformat ascii 1.0\ncomment TextureFile none.png\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nproperty " +
            type + " red\nproperty " + type + " green\nproperty " + type +
            " blue\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 0 0 " +
            half + "\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n";
        const auto parts = read(text);
        ASSERT_EQ(parts.at(0).mesh.colors.size(), 3u);
        EXPECT_NEAR(parts[0].mesh.colors[0].z, whole ? 0.2159f : 0.5f, 1e-4f);
        EXPECT_EQ(warnings().size(), 1u) << "there is no none.png";
    }
}

/// char, short and int reach to 127, 32767 and 2147483647; what is negative is black. 64 / 127 is 0.2177 in linear light, 1 / 2 is 0.2140.
TEST_F(Ply, SignedColoursReachToTheLargestOfTheirType) {
    struct Case {
        std::string type, values;
        float linear;
    };
    for (const Case &c : {Case{"char", "127 -1 64", 0.2177f}, {"short", "32767 -1 16383", 0.2140f}, {"int", "2147483647 -1 1073741823", 0.2140f}}) {
        std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
        for (const char *name : {"red", "green", "blue"}) text += "property " + c.type + " " + name + "\n";
        text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
        const Spectrum color = read(text + "0 0 0 " + c.values + "\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n").at(0).mesh.colors.at(0);
        EXPECT_EQ(color.x, 1) << c.type;
        EXPECT_EQ(color.y, 0) << c.type;
        EXPECT_NEAR(color.z, c.linear, 1e-4f) << c.type;
    }
}

/// Two triangles with an edge in common, red and green: the vertices of the edge are two each. Before those of vertices, which are blue.
TEST_F(Ply, FacesMayHaveColoursOfTheirOwn) {
    for (const bool vertices_too : {false, true}) {
        const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n", own = vertices_too ? " 0 0 255\n" : "\n";
        const auto parts =
            read("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + (vertices_too ? colors : "") +
                 "element face 2\nproperty list uchar int vertex_indices\n" + colors + "property uchar alpha\nend_header\n0 0 0" + own + "1 0 0" +
                 own + "1 1 0" + own + "0 1 0" + own + "3 0 1 2 255 0 0 9\n3 0 2 3 0 255 0 9\n");
        const MeshData &mesh = parts.at(0).mesh;
        ASSERT_EQ(mesh.indices.size(), 6u);
        ASSERT_EQ(mesh.colors.size(), 6u);
        for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(mesh.colors[mesh.indices[i]], i < 3 ? Spectrum(1, 0, 0) : Spectrum(0, 1, 0)) << i;
        EXPECT_EQ(whitted_of(folder.scene.materials.at(parts[0].material).record).diffuse, Spectrum(1));
        EXPECT_TRUE(warnings().empty());
    }
}

TEST_F(Ply, LinesMayEndWithCarriageReturnsAlone) {
    std::string text = "\xef\xbb\xbf" + triangle_header + triangle_values;
    std::replace(text.begin(), text.end(), '\n', '\r');
    EXPECT_EQ(corners_of(read(text).at(0)), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f}}));
    std::string header = triangle_header;
    std::replace(header.begin(), header.end(), '\n', '\r');
    header.replace(header.find("ascii"), 5, "binary_little_endian");
    Bytes bytes(false);
    // The first byte of data is that of a line feed.
    bytes.add<std::uint32_t>({0x3f80000a}).add<float>({0, 0, 1, 0, 0, 0, 1, 0}).add<std::uint8_t>({3}).add<std::int32_t>({0, 1, 2});
    EXPECT_EQ(corners_of(read(header + bytes.text).at(0))[0], vec3(std::bit_cast<float>(0x3f80000a), 0, 0));
    EXPECT_TRUE(warnings().empty());
}

TEST_F(Ply, DataBehindTheLastElementIsCounted) {
    Bytes bytes(true);
    bytes.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}).add<std::uint8_t>({3}).add<std::int32_t>({0, 1, 2});
    std::string header = triangle_header;
    header.replace(header.find("ascii"), 5, "binary_big_endian");
    const std::map<std::string, uint> one = {{"data behind the last element: left out", 1}};
    for (const char *end : {"", "\n", "\r\n \n"}) {
        read(triangle_header + triangle_values + end);
        EXPECT_TRUE(warnings().empty());
        read(header + bytes.text + end);
        EXPECT_TRUE(warnings().empty());
    }
    read(triangle_header + triangle_values + "3 2 1 0\n");
    EXPECT_EQ(warnings(), one);
    read(header + bytes.text + std::string(1, '\0'));
    EXPECT_EQ(warnings(), one);
}

/// Five vertices in a row of triangles, and another triangle after a restart; every second one turns about.
TEST_F(Ply, Strips) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
        "property list int int vertex_indices\nend_header\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n9 0 1 2 3 4 -1 4 3 2\n";
    const auto corners = corners_of(read(text).at(0));
    ASSERT_EQ(corners.size(), 12u);
    for (std::size_t i = 0; i < 9; i += 3)
        EXPECT_LT(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]).z, 0) << i;  // clockwise, as the first
    EXPECT_EQ(corners[9], vec3(2, 0, 0));
}

TEST_F(Ply, WhatCannotBeSeenIsCounted) {
    EXPECT_TRUE(read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n").empty());
    EXPECT_EQ(warnings().at("points without faces: left out"), 1u);
    EXPECT_EQ(error("1 0 0", "nan 0 0"), "");
    EXPECT_EQ(warnings().at("face with a vertex that is no number or beyond 1e15: left out"), 1u);
    EXPECT_EQ(error("3 0 1 2", "2 0 1"), "");
    EXPECT_EQ(warnings().at("face with fewer than 3 corners: left out"), 1u);
}

TEST_F(Ply, BadHeadersAreErrorsWithTheirLine) {
    EXPECT_EQ(error("obj\n"), "mesh.ply:1: not a PLY file: it does not begin with the line \"ply\"");
    EXPECT_EQ(error("ply"), "mesh.ply:1: the header has no end: \"end_header\" is missing");
    EXPECT_EQ(error("format ascii 1.0", "format text 1.0"),
              "mesh.ply:2: unknown format \"text\"; known: ascii, binary_little_endian, binary_big_endian");
    EXPECT_EQ(error("format ascii 1.0", "format ascii 2.0"), "mesh.ply:2: unknown version \"2.0\"; known: 1.0");
    EXPECT_EQ(error("element vertex 3", "element vertex -3"), "mesh.ply:4: element: expected a count, found \"-3\"");
    EXPECT_EQ(error("element vertex 3", "element vertex"), "mesh.ply:4: expected \"element NAME COUNT\"");
    EXPECT_EQ(error("element vertex 3\n", ""), "mesh.ply:4: property before any element");
    EXPECT_EQ(error("property float x", "property real x"), "mesh.ply:5: unknown type \"real\"");
    EXPECT_EQ(error("property float y", "property float x"), "mesh.ply:6: second property \"x\"");
    EXPECT_EQ(error("list uchar int", "list float int"), "mesh.ply:9: the length of a list cannot be of type \"float\"");
    EXPECT_EQ(error("element face 1", "element vertex 1"), "mesh.ply:8: second element \"vertex\"");
    EXPECT_EQ(error("element face 1", "elements face 1"), "mesh.ply:8: expected one of comment, element, property, end_header, found \"elements\"");
    EXPECT_EQ(error("end_header", "end header").find("mesh.ply:10: expected one of"), 0u);
    EXPECT_NE(error("float z", "float w").find("element \"vertex\" has not all of the properties x, y and z"), std::string::npos);
    EXPECT_NE(error("vertex_indices", "vertices").find("element \"face\" has no list vertex_indices"), std::string::npos);
}

TEST_F(Ply, BadValuesAreErrorsWithTheirPlace) {
    EXPECT_EQ(error("3 0 1 2", "3 0 1 3"), "mesh.ply:14: face: there is no vertex 3; 3 have been read");
    EXPECT_EQ(error("3 0 1 2", "3 0 1 -1"), "mesh.ply:14: face: there is no vertex -1; 3 have been read");
    EXPECT_EQ(error("3 0 1 2", "3 0 1 1.5"), "mesh.ply:14: value of a list: expected a whole number, found \"1.5\"");
    EXPECT_EQ(error("3 0 1 2", "3 0 1"), "mesh.ply:15: value of a list: expected a whole number, found the end of the file");
    EXPECT_EQ(error("1 0 0", "1 O 0"), "mesh.ply:12: property of a vertex: expected a number, found \"O\"");
}

/// No memory is taken for what the file cannot have.
TEST_F(Ply, HugeCountsInSmallFilesAreErrors) {
    EXPECT_NE(error("element vertex 3", "element vertex 18446744073709551615").find("the header promises 18446744073709551615 of element \"vertex\""),
              std::string::npos);
    EXPECT_NE(error("element face 1", "element face 99999999999").find("the header promises 99999999999 of element \"face\""), std::string::npos);
    EXPECT_NE(error("3 0 1 2", "4000000000 0 1 2").find("a list of 4000000000 values, but only"), std::string::npos);
    EXPECT_NE(error("3 0 1 2", "-1 0 1 2").find("a list of -1 values"), std::string::npos);
    EXPECT_EQ(error("element face 1", "element nothing 18446744073709551615\nelement face 1"), "");
}

}  // namespace
}  // namespace brandung
