#include "scene/lights/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace brandung {
namespace {

/// Mostly dark, with spots of all brightnesses.
Picture stars(uint width, uint height) {
    std::mt19937 engine(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    Picture picture{width, height, std::vector<vec3>(std::size_t{width} * height), {}};
    for (vec3 &pixel : picture.pixels)
        if (uniform(engine) < 0.1f) pixel = vec3(uniform(engine), uniform(engine), 0) * std::pow(10.0f, 2 * uniform(engine));
    return picture;
}

/// Between texels, as kernels have it: mean of the channels at a place in texels from the left upper corner.
double brightness_at(const Picture &picture, double x, double y) {
    const int width = int(picture.width), height = int(picture.height), left = int(std::floor(x - 0.5)), above = int(std::floor(y - 0.5));
    double sum = 0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const int row = std::clamp(above + j, 0, height - 1), column = (left + i + width) % width;
            const vec3 texel = picture.pixels[std::size_t(row * width + column)];
            sum += (1 - std::abs(x - 0.5 - (left + i))) * (1 - std::abs(y - 0.5 - (above + j))) * (double(texel.x) + texel.y + texel.z) / 3;
        }
    return sum;
}

/// Of a cell, by n * n places in it.
double mean_of_cell(const Picture &picture, const EnvironmentTable &table, uint row, uint column) {
    constexpr int n = 48;
    double sum = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            sum += brightness_at(picture, (column + (i + 0.5) / n) * picture.width / table.columns,
                                 (row + (j + 0.5) / n) * picture.height / double(table.row_count()));
    return sum / (n * n);
}

/// As kernels read them.
struct Cell {
    float begin, end, density;
};

Cell cell_of(const EnvironmentTable &table, uint row, uint column) {
    const float *begin = &table.begins.at(row * ENVIRONMENT_STRIDE(table.columns) + column);
    return {begin[0], begin[1], table.rows.at(row).density * (begin[1] - begin[0])};
}

struct Size {
    uint width, height;
};

class Environments : public testing::TestWithParam<Size> {};

/// Densities are the cells' means over that of all; those of the solid angle are 1 on average; and chances make them up.
TEST_P(Environments, CellsAreAsLikelyAsTheyAreBright) {
    const Picture picture = stars(GetParam().width, GetParam().height);
    const EnvironmentTable table = make_environment(picture, Spectrum(1));
    EXPECT_LE(table.row_count(), MAX_ENVIRONMENT_ROWS);
    EXPECT_LE(table.columns, MAX_ENVIRONMENT_COLUMNS);
    const uint marks = (table.columns + ENVIRONMENT_MARK - 1) / ENVIRONMENT_MARK;
    EXPECT_EQ(table.marks.size(), marks * table.row_count());
    double sum = 0;
    float row_place = 0;
    for (uint row = 0; row < table.row_count(); ++row) {
        const EnvironmentRow &r = table.rows[row], &next = table.rows[row + 1];
        ASSERT_EQ(r.begin, row_place);
        ASSERT_NEAR(r.high, std::cos(std::numbers::pi * row / double(table.row_count())), 1e-7);
        row_place = next.begin;
        const double part = (double(r.high) - double(next.high)) / 2 / table.columns;
        float place = 0;
        for (uint column = 0; column < table.columns; ++column) {
            const Cell cell = cell_of(table, row, column);
            ASSERT_EQ(cell.begin, place);
            place = cell.end;
            ASSERT_EQ(table.marks.at(row * marks + column / ENVIRONMENT_MARK), cell_of(table, row, column - column % ENVIRONMENT_MARK).begin);
            sum += double(cell.density) * part;
            // Chances are multiples of 2^-24: of the row, and in it.
            const double chance = double(next.begin - r.begin) * double(cell.end - cell.begin);
            ASSERT_NEAR(double(cell.density) * part, chance, 1e-3 * chance + 1e-12);  // near the poles cosines differ by few of their digits
            if ((row * table.columns + column) % 97 != 0) continue;
            const double expected = mean_of_cell(picture, table, row, column) / double(table.radiance);
            // Places 1/48 of a cell apart, in the hundred times brighter light of a texel's edge; and steps of chances.
            const double steps = 0.02 / double(table.radiance),
                         chances = 0x1p-23 / part * (double(next.begin - r.begin) + double(cell.end - cell.begin));
            ASSERT_NEAR(cell.density, expected, 5e-3 * expected + steps + chances) << row << ", " << column;
        }
        ASSERT_EQ(place, 1);
    }
    EXPECT_EQ(row_place, 1);
    EXPECT_NEAR(sum, 1, 1e-5);
}

/// Larger than the table, which leaves odd parts of texels to its cells, and smaller.
INSTANTIATE_TEST_SUITE_P(Scene, Environments, testing::Values(Size{3, 1}, Size{7, 5}, Size{64, 32}, Size{200, 100}, Size{1500, 777}),
                         [](const auto &info) { return "Size" + std::to_string(info.param.width) + "x" + std::to_string(info.param.height); });

/// One texel of eight million, next to the seam: it reaches half a texel beyond its edges, and to the other side of the picture.
TEST(Environment, ASunIsNotLost) {
    Picture picture{4096, 2048, std::vector<vec3>(std::size_t{4096} * 2048), {}};
    picture.pixels[std::size_t{1000} * 4096] = vec3(0, 0, 60000);
    const EnvironmentTable table = make_environment(picture, Spectrum(1));
    const uint columns = table.columns, row = 1000 * uint(table.row_count()) / 2048;
    EXPECT_GT(cell_of(table, row, 0).density, 0);
    EXPECT_GT(cell_of(table, row, columns - 1).density, 0);
    EXPECT_EQ(cell_of(table, row, 1).density, 0);
    EXPECT_EQ(cell_of(table, row + 1, 0).density, 0);
    const double angle = std::numbers::pi / 2048, part = std::sin((1000.5) * angle) * angle / 2 / 4096;
    EXPECT_NEAR(double(table.radiance) / (20000 * part), 1, 1e-3);
}

TEST(Environment, BlackOnesAreNone) {
    EXPECT_TRUE(make_environment({4, 2, std::vector<vec3>(8), {}}, Spectrum(1)).rows.empty());
    EXPECT_TRUE(make_environment({4, 2, std::vector<vec3>(8, vec3(1, 0, 0)), {}}, Spectrum(0, 1, 1)).rows.empty());
}

}  // namespace
}  // namespace brandung
