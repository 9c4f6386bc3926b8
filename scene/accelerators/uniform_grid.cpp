/// Sorts references into the cells of a uniform grid.
#include "kernels/accelerators/uniform_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cfloat>
#include <cmath>
#include <numeric>

#include "scene/accelerators/cell_lists.h"

namespace brandung {
namespace {

constexpr double cells_per_reference = 4;         ///< on the SPD scenes 2 and 8 lose up to a fifth on some and gain less on others
constexpr std::uint64_t most_per_reference = 24;  ///< entries in lists, on average: beyond, cells are made larger
constexpr double most_columns = 1 << 20;          ///< floats number planes exactly

/// Cells as near to cubes as the box allows, `cells` of them: axes along which the box is thinner than such a cube are not divided, and the
/// others share what that leaves; none narrower than `least` (after Klimaszewski and Sederberg, Faster Ray Tracing Using Adaptive Grids, IEEE CG&A
/// 17(1) 1997).
std::array<double, 3> columns_for(glm::dvec3 extent, double least, double cells) {
    std::array<double, 3> columns = {0, 0, 0};
    for (int divided = 3; divided > 0;) {
        double volume = 1;
        for (int axis = 0; axis < 3; ++axis)
            if (columns[size_t(axis)] == 0) volume *= extent[axis];
        const double edge = std::pow(volume / cells, 1.0 / divided);
        int thin = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (columns[size_t(axis)] == 0 && !(extent[axis] > std::max(edge, least))) columns[size_t(axis)] = 1, ++thin;
        divided -= thin;
        if (thin > 0) continue;
        for (int axis = 0; axis < 3; ++axis)
            if (columns[size_t(axis)] == 0) columns[size_t(axis)] = std::min(std::floor(extent[axis] / std::max(edge, least) + 0.5), most_columns);
        break;
    }
    return columns;
}

/// The last plane lies on the box's upper side or beyond, however it is rounded.
float cell_size(float low, float high, uint columns) {
    float size = std::max((high - low) / float(columns), FLT_MIN);
    while (low + float(columns) * size < high && size < FLT_MAX) size = std::nextafter(size, FLT_MAX);
    return size;
}

/// By which the rays' boxes are grown at least (kernels/core/lane_ray.cl).
double least_pad(const Bounds &bounds) {
    const vec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    return 0x1p-20 * std::max({farthest.x, farthest.y, farthest.z});
}

/// Rays are in several columns at once where these are not wider than the pad.
UniformGrid grid_of(const Bounds &bounds, double cells) {
    const std::array<double, 3> columns = columns_for(glm::dvec3(bounds.high) - glm::dvec3(bounds.low), 4 * least_pad(bounds), cells);
    UniformGrid grid{};
    grid.low = bounds.low;
    for (int axis = 0; axis < 3; ++axis) {
        grid.columns[axis] = uint(columns[size_t(axis)]);
        grid.size[axis] = cell_size(bounds.low[axis], bounds.high[axis], grid.columns[axis]);
    }
    return grid;
}

std::size_t cell_count(const UniformGrid &grid) { return std::size_t{grid.columns[0]} * grid.columns[1] * grid.columns[2]; }

struct Columns {
    uint first, last;
    uint count() const { return last - first + 1; }
};

/// Those of whose inside a box has a part along an axis; of a flat box in a plane of the grid, the one above, or the last.
Columns columns_of(const UniformGrid &grid, const Bounds &bounds, int axis) {
    const float low = bounds.low[axis], high = bounds.high[axis], size = grid.size[axis];
    const uint end = grid.columns[axis] - 1;
    const auto plane = [&](uint i) { return grid.low[axis] + float(i) * size; };
    const auto guess = [&](float p) { return uint(std::clamp((double(p) - grid.low[axis]) / size, 0.0, double(end))); };
    Columns columns{guess(low), guess(high)};
    while (columns.first < end && plane(columns.first + 1) <= low) ++columns.first;
    while (columns.first > 0 && plane(columns.first) > low) --columns.first;
    while (columns.last < end && plane(columns.last + 1) < high) ++columns.last;
    while (columns.last > columns.first && plane(columns.last) >= high) --columns.last;
    columns.last = std::max(columns.first, columns.last);
    return columns;
}

struct CellRange {
    Columns x, y, z;
    std::uint64_t count() const { return std::uint64_t{x.count()} * y.count() * z.count(); }

    template <class See> void for_each(const UniformGrid &grid, See see) const {
        for (uint k = z.first; k <= z.last; ++k)
            for (uint j = y.first; j <= y.last; ++j)
                for (uint i = x.first; i <= x.last; ++i) see((std::size_t{k} * grid.columns[1] + j) * grid.columns[0] + i);
    }
};

std::vector<CellRange> ranges_of(const UniformGrid &grid, std::span<const Reference> references) {
    std::vector<CellRange> ranges(references.size());
    tbb::parallel_for(std::size_t(0), references.size(), [&](std::size_t i) {
        const Bounds &bounds = references[i].bounds;
        ranges[i] = {columns_of(grid, bounds, 0), columns_of(grid, bounds, 1), columns_of(grid, bounds, 2)};
    });
    return ranges;
}

std::uint64_t entries(const std::vector<CellRange> &ranges) {
    return std::accumulate(ranges.begin(), ranges.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const CellRange &range) { return sum + range.count(); });
}

/// Threads take places in a cell's list as they come; sorting undoes that.
Cells fill_cells(const UniformGrid &grid, const std::vector<CellRange> &ranges, BuildProgress &progress) {
    std::vector<std::atomic<uint>> counts(cell_count(grid));
    tbb::parallel_for(std::size_t(0), ranges.size(), [&](std::size_t i) {
        ranges[i].for_each(grid, [&](std::size_t cell) { counts[cell].fetch_add(1, std::memory_order_relaxed); });
    });
    Cells cells;
    cells.starts.resize(counts.size() + 1);
    for (std::size_t cell = 0; cell < counts.size(); ++cell) cells.starts[cell + 1] = cells.starts[cell] + counts[cell].exchange(0);
    check_entries(entries(ranges), "uniform_grid");
    cells.members.resize(cells.starts.back());
    tbb::parallel_for(std::size_t(0), ranges.size(), [&](std::size_t i) {
        ranges[i].for_each(
            grid, [&](std::size_t cell) { cells.members[cells.starts[cell] + counts[cell].fetch_add(1, std::memory_order_relaxed)] = uint(i); });
        progress.add(1);
    });
    tbb::parallel_for(std::size_t(0), counts.size(), [&](std::size_t cell) {
        std::sort(cells.members.begin() + cells.starts[cell], cells.members.begin() + cells.starts[cell + 1]);
    });
    return cells;
}

/// Cells that hold half of everything each are no help, nor are lists that take more than memory allows.
bool pays(std::uint64_t entries, std::size_t cells, std::size_t references) {
    return entries <= most_per_reference * references && double(entries) / double(cells) <= 0.5 * double(references);
}

}  // namespace

BuiltAccelerator build_uniform_grid(std::span<const Reference> references, const Hulls &, BuildQuality, BuildProgress &progress) {
    progress.begin(references.size());
    const Bounds bounds = bounds_of(references);
    for (double cells = cells_per_reference * double(std::max<std::size_t>(references.size(), 1));; cells = std::floor(cells / 8)) {
        const UniformGrid grid = grid_of(bounds, std::max(cells, 1.0));
        const std::vector<CellRange> ranges = ranges_of(grid, references);
        if (cells > 1 && !pays(entries(ranges), cell_count(grid), references.size())) continue;
        CellLists lists = list_cells(references, fill_cells(grid, ranges, progress), "uniform_grid");
        const std::vector<uint> cell_words = std::move(lists.lists);
        return built_of_cells(grid, cell_words, std::move(lists));
    }
}

}  // namespace brandung
