#include "tests/images/spd_teapot.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <glm/glm.hpp>
#include <stdexcept>
#include <vector>

namespace spd {

namespace {

using Vec = glm::dvec3;
constexpr unsigned given = 6;  ///< the file's size
constexpr unsigned patch_count = 32;
constexpr double half_board = 4;

struct Corner {
    Vec point, normal;
};
using Triangle = std::array<Corner, 3>;

/// Bernstein's polynomials, and their derivatives.
glm::dvec4 bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
}
glm::dvec4 slopes(double t) {
    const double s = 1 - t;
    return {-3 * s * s, 3 * s * s - 6 * t * s, 6 * t * s - 3 * t * t, 3 * t * t};
}

/// A bicubic patch. Its first row may be one point, a pole, where the normal is not defined by the surface.
class Patch {
public:
    /// Takes its triangles, row by row, off the list. The patch is the one with the least squares of distances to the corners.
    explicit Patch(const Triangle *&next) : has_pole_(next[0][2].point != next[1][0].point) {
        Vec points[given + 1][given + 1];
        for (unsigned row = 0; row < given; ++row)
            for (unsigned column = 0; column < given; ++column) {
                if (row > 0 || !has_pole_) {
                    const Triangle &upper = *next++;
                    points[row][column] = upper[0].point, points[row][column + 1] = upper[1].point, points[row + 1][column + 1] = upper[2].point;
                }
                const Triangle &lower = *next++;
                points[row + 1][column + 1] = lower[0].point, points[row + 1][column] = lower[1].point, points[row][column] = lower[2].point;
                if (row == 0 && has_pole_) points[0][column + 1] = lower[2].point, pole_normal_ = lower[2].normal;
            }
        glm::dmat4 products(0);
        for (unsigned i = 0; i <= given; ++i) products += glm::outerProduct(at(i), at(i));
        const glm::dmat4 inverse = glm::inverse(products);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                controls_[i][j] = Vec(0);
                for (unsigned row = 0; row <= given; ++row)
                    for (unsigned column = 0; column <= given; ++column)
                        controls_[i][j] += (inverse * at(row))[i] * (inverse * at(column))[j] * points[row][column];
            }
    }

    bool has_pole() const { return has_pole_; }

    Corner operator()(double u, double v) const {
        const Vec point = sum(bernstein(u), bernstein(v));
        if (has_pole_ && u == 0) return {point, pole_normal_};
        return {point, glm::normalize(glm::cross(sum(bernstein(u), slopes(v)), sum(slopes(u), bernstein(v))))};
    }

private:
    static glm::dvec4 at(unsigned i) { return bernstein(static_cast<double>(i) / given); }
    Vec sum(const glm::dvec4 &a, const glm::dvec4 &b) const {
        Vec result(0);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) result += a[i] * b[j] * controls_[i][j];
        return result;
    }

    bool has_pole_;
    Vec pole_normal_{0};
    Vec controls_[4][4];
};

struct File {
    std::string head;                    ///< before the first surface
    std::vector<std::string> materials;  ///< the board's two and the teapot's
    std::vector<Triangle> triangles;
};

File read(const std::string &name) {
    std::ifstream stream(name);
    if (!stream) throw std::runtime_error("cannot read " + name);
    File file;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("f ")) {
            file.materials.push_back(line);
        } else if (line == "pp 3") {
            Triangle triangle;
            for (auto &[point, normal] : triangle) stream >> point.x >> point.y >> point.z >> normal.x >> normal.y >> normal.z;
            file.triangles.push_back(triangle);
        } else if (file.materials.empty()) {
            file.head += line + "\n";
        }
    }
    if (file.materials.size() != 3 || file.triangles.size() != 2256) throw std::runtime_error(name + " is not the teapot of size 6");
    return file;
}

/// The squares of one colour.
std::string board(unsigned size, unsigned colour) {
    std::string text;
    const auto at = [&](unsigned i) { return -half_board + 2 * half_board * i / size; };
    for (unsigned x = 0; x < size; ++x)
        for (unsigned y = (x + 1 + colour) % 2; y < size; y += 2)
            text += fmt::format("p 4\n{0:g} {1:g} 0\n{2:g} {1:g} 0\n{2:g} {3:g} 0\n{0:g} {3:g} 0\n", at(x), at(y), at(x + 1), at(y + 1));
    return text;
}

std::string triangle(const Corner &a, const Corner &b, const Corner &c) {
    std::string text = "pp 3\n";
    for (const auto &[p, n] : {a, b, c}) text += fmt::format("{:g} {:g} {:g} {:g} {:g} {:g}\n", p.x, p.y, p.z, n.x, n.y, n.z);
    return text;
}

}  // namespace

std::string teapot_of_size(const std::string &file, unsigned size) {
    const File original = read(file);
    std::string text = original.head;
    for (unsigned colour = 0; colour < 2; ++colour) text += original.materials[colour] + "\n" + board(size, colour);
    text += original.materials[2] + "\n";
    const Triangle *next = original.triangles.data();
    for (unsigned i = 0; i < patch_count; ++i) {
        const Patch patch(next);
        const auto corner = [&](unsigned row, unsigned column) { return patch(static_cast<double>(row) / size, static_cast<double>(column) / size); };
        for (unsigned row = 0; row < size; ++row)
            for (unsigned column = 0; column < size; ++column) {
                if (row > 0 || !patch.has_pole()) text += triangle(corner(row, column), corner(row, column + 1), corner(row + 1, column + 1));
                text += triangle(corner(row + 1, column + 1), corner(row + 1, column), corner(row, column));
            }
    }
    return text;
}

}  // namespace spd
