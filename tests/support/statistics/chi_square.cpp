#include "tests/support/statistics/chi_square.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace brandung::statistics {
namespace {

struct Cell {
    double count, expected;
};

/// In ascending order of what is expected, none of fewer than `least`, unless all together are.
std::vector<Cell> pooled(std::vector<Cell> cells, double least) {
    std::sort(cells.begin(), cells.end(), [](const Cell &a, const Cell &b) { return a.expected < b.expected; });
    std::vector<Cell> result;
    Cell pool{0, 0};
    for (const Cell &cell : cells) {
        pool = {pool.count + cell.count, pool.expected + cell.expected};
        if (pool.expected < least) continue;
        result.push_back(pool);
        pool = {0, 0};
    }
    if (result.empty()) return {pool};
    result.back() = {result.back().count + pool.count, result.back().expected + pool.expected};
    return result;
}

}  // namespace

ChiSquare chi_square(std::span<const std::uint64_t> counts, std::span<const double> expected) {
    if (counts.size() != expected.size()) throw std::invalid_argument("chi_square: as many expectations as counts");
    const double things = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    const double unit = things / std::accumulate(expected.begin(), expected.end(), 0.0);
    std::vector<Cell> cells;
    bool impossible = false;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        cells.push_back({static_cast<double>(counts[i]), expected[i] * unit});
        impossible |= counts[i] > 0 && expected[i] == 0;
    }
    cells = pooled(std::move(cells), 5);
    if (cells.size() < 2) throw std::invalid_argument("chi_square: too few things to tell anything");
    double statistic = 0;
    for (const Cell &cell : cells) statistic += (cell.count - cell.expected) * (cell.count - cell.expected) / cell.expected;
    const double degrees = static_cast<double>(cells.size() - 1);
    const double p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), statistic));
    return {statistic, degrees, impossible ? 0 : p};
}

}  // namespace brandung::statistics
