#include "scene/lights/emissive_cells.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "scene/bounds.h"
#include "scene/lights/aliases.h"
#include "scene/lights/emissive_faces.h"

namespace brandung {
namespace {

vec3 middle_of(const EmissiveFace &face) { return face.corner + (face.u + face.v) * (face.folded > 0 ? 1 / 3.0f : 0.5f); }

/// The bits of three numbers below 2^21 in turn.
std::uint64_t interleaved(const glm::u64vec3 &cell) {
    std::uint64_t code = 0;
    for (uint bit = 0; bit < 21; ++bit)
        for (uint axis = 0; axis < 3; ++axis) code |= (cell[int(axis)] >> bit & 1) << (3 * bit + axis);
    return code;
}

void sort_along_curve(std::vector<EmissiveFace> &faces) {
    Bounds bounds;
    for (const EmissiveFace &face : faces) bounds.add(middle_of(face));
    const glm::dvec3 low(bounds.low), size = glm::max(glm::dvec3(bounds.high) - low, glm::dvec3(1e-300));
    std::vector<std::pair<std::uint64_t, uint>> order;
    for (uint i = 0; i < faces.size(); ++i)
        order.push_back({interleaved(glm::u64vec3((glm::dvec3(middle_of(faces[i])) - low) / size * double((1 << 21) - 1))), i});
    std::sort(order.begin(), order.end());
    std::vector<EmissiveFace> sorted;
    for (const auto &[code, i] : order) sorted.push_back(faces[i]);
    faces = std::move(sorted);
}

double part_of(const EmissiveFace &face) { return (double(face.last - face.first) + 1) * 0x1p-32; }

void write_aliases(std::span<EmissiveFace> faces) {
    std::vector<double> areas;
    for (const EmissiveFace &face : faces) areas.push_back(area_of(face) * part_of(face));
    const std::vector<Alias> aliases = make_aliases(areas);
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i].kept = aliases[i].kept, faces[i].alias = aliases[i].alias;
}

/// How far along a face's curve an area leads [2^-32].
std::uint64_t place_on(const EmissiveFace &face, double area) { return std::uint64_t(std::clamp(area / area_of(face), 0.0, 1.0) * 0x1p32); }

}  // namespace

EmissiveCells make_emissive_cells(std::vector<EmissiveFace> faces, uint cells) {
    sort_along_curve(faces);
    EmissiveCells result;
    for (const EmissiveFace &face : faces) result.area += area_of(face);
    std::size_t i = 0;
    double before = 0;  // area of the faces before i
    for (uint cell = 0; cell < cells; ++cell) {
        result.first.push_back(uint(result.faces.size()));
        const bool is_last = cell + 1 == cells;
        const double begin = result.area * cell / cells, end = result.area * (cell + 1) / cells;
        while (i < faces.size()) {
            EmissiveFace face = faces[i];
            const double area = area_of(face);
            const std::uint64_t from = place_on(face, begin - before), to = is_last ? std::uint64_t{1} << 32 : place_on(face, end - before);
            face.first = uint(from), face.last = uint(to - 1);
            if (to > from) result.faces.push_back(face);
            if (to < std::uint64_t{1} << 32) break;
            before += area, ++i;
        }
        write_aliases(std::span(result.faces).subspan(result.first.back()));
    }
    result.first.push_back(uint(result.faces.size()));
    return result;
}

}  // namespace brandung
