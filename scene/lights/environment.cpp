#include "scene/lights/environment.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <span>

#include "scene/kinds.h"
#include "scene/lights/light.h"

namespace brandung {
namespace {

/// Small pictures are divided further, since between their texels brightness changes much.
constexpr uint min_rows = 32, min_columns = 64;
/// Numbers that choose are multiples of one over this.
constexpr double steps = 1 << 24;

/// The part of a texel that counts before the place x, in widths of a texel from its middle: the integral of the tent that is its weight.
double tent_before(double x) {
    if (x <= -1) return 0;
    if (x >= 1) return 1;
    return x < 0 ? (1 + x) * (1 + x) / 2 : 1 - (1 - x) * (1 - x) / 2;
}

/// Means over `cells` equal parts of what is linear between the middles of `count` texels, which `texel` gives, from -1 to `count` too.
void add_means(std::span<double> cells, uint count, const std::function<double(int)> &texel) {
    const double width = double(count) / double(cells.size());
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const double from = double(cell) * width, to = from + width;
        for (int i = int(std::floor(from - 0.5)); i < int(std::ceil(to + 0.5)); ++i)
            cells[cell] += (tent_before(to - i - 0.5) - tent_before(from - i - 0.5)) / width * texel(i);
    }
}

/// Means of the picture's brightness over columns * rows cells.
std::vector<double> means_of(const Picture &picture, Spectrum scale, uint columns, uint rows) {
    const int width = int(picture.width), height = int(picture.height);
    std::vector<double> across(std::size_t{columns} * picture.height), means(std::size_t{columns} * rows), cells(rows);
    for (int y = 0; y < height; ++y)
        add_means(std::span(across).subspan(std::size_t(y) * columns, columns), picture.width, [&](int x) {
            const vec3 light = picture.pixels[std::size_t(y) * picture.width + std::size_t((x + width) % width)] * scale;
            return (double(light.x) + light.y + light.z) / 3;
        });
    for (uint column = 0; column < columns; ++column) {
        std::fill(cells.begin(), cells.end(), 0.0);
        add_means(cells, picture.height, [&](int y) { return across[std::size_t(std::clamp(y, 0, height - 1)) * columns + column]; });
        for (uint row = 0; row < rows; ++row) means[std::size_t{row} * columns + column] = cells[row];
    }
    return means;
}

/// Where in [0, 1] each of the weights begins, and the last one ends, to whole steps; all but the last begin at 0 if the sum is.
std::vector<double> cumulated(std::span<const double> weights) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<double> places = {0};
    double before = 0;
    for (const double weight : weights) places.push_back(sum > 0 ? std::round((before += weight) / sum * steps) / steps : 0);
    places.back() = 1;
    return places;
}

}  // namespace

EnvironmentTable make_environment(const Picture &picture, Spectrum scale) {
    const uint columns = std::clamp(picture.width, min_columns, MAX_ENVIRONMENT_COLUMNS),
               rows = std::clamp(picture.height, min_rows, MAX_ENVIRONMENT_ROWS);
    const std::vector<double> means = means_of(picture, scale, columns, rows);
    const auto edge = [&](uint row) { return std::cos(std::numbers::pi * row / rows); };
    std::vector<double> weights;
    for (uint row = 0; row < rows; ++row) {
        const auto first = means.begin() + std::ptrdiff_t(row) * columns;
        weights.push_back(std::accumulate(first, first + columns, 0.0) / columns * (edge(row) - edge(row + 1)) / 2);
    }
    EnvironmentTable table;
    table.radiance = float(std::accumulate(weights.begin(), weights.end(), 0.0));
    if (!(table.radiance > 0)) return {};
    const std::vector<double> row_places = cumulated(weights);
    for (uint row = 0; row < rows; ++row) {
        const double chance = row_places[row + 1] - row_places[row], part = (edge(row) - edge(row + 1)) / 2;
        table.rows.push_back({float(row_places[row]), float(edge(row)), float(chance / part * columns)});
        const std::vector<double> places = cumulated(std::span(means).subspan(std::size_t{row} * columns, columns));
        table.begins.insert(table.begins.end(), places.begin(), places.end());
        table.begins.resize((row + 1) * ENVIRONMENT_STRIDE(columns), 1);
        for (uint column = 0; column < columns; column += ENVIRONMENT_MARK) table.marks.push_back(float(places[column]));
    }
    table.rows.push_back({1, -1, 0});
    table.columns = columns;
    return table;
}

Light make_light(const Environment &light) {
    Light result{};
    result.kind = kind_number(light_kinds(), "environment");
    write_words(light, result.words);
    return result;
}

/// Irradiance from all directions, 4 pi times the radiance, on a disk of the scene's extent.
Spectrum power_of_environment(const Light &light, float extent) {
    return Spectrum(view_of<Environment>(light.words).radiance * 4 * std::numbers::pi_v<float> * std::numbers::pi_v<float> * extent * extent);
}

}  // namespace brandung
