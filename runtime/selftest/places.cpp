#include "runtime/selftest/places.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "runtime/selftest/segment.h"

namespace brandung {
namespace {

std::span<const uint, 3> corners_of(const MeshData &mesh, uint face) { return std::span<const uint, 3>(&mesh.indices[3 * face], 3); }

bool meet_in_one_place(const MeshData &mesh, const Ray &ray, uint a, uint b) {
    const auto of_a = corners_of(mesh, a), of_b = corners_of(mesh, b);
    std::vector<Vector> shared;
    extended farthest = 0;
    for (const uint vertex : of_a) {
        const Vector seen = Vector(mesh.positions[vertex]) - Vector(ray.origin);
        farthest = greater(farthest, largest(seen));
        if (std::find(of_b.begin(), of_b.end(), vertex) != of_b.end()) shared.push_back(part_across(seen, ray.direction));
    }
    for (const uint vertex : of_b) farthest = greater(farthest, largest(Vector(mesh.positions[vertex]) - Vector(ray.origin)));
    const extended doubtful = doubtful_of_vertices * farthest;
    return !shared.empty() && square_to_segment(shared.front(), shared.back()) <= doubtful * doubtful;
}

}  // namespace

uint places_met(const MeshData &mesh, const Ray &ray, std::span<const uint> faces) {
    std::vector<std::size_t> place(faces.size());  // the first face of each one's place
    std::iota(place.begin(), place.end(), std::size_t{0});
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (place[i] != place[j] && meet_in_one_place(mesh, ray, faces[i], faces[j])) {
                const std::size_t kept = std::min(place[i], place[j]), gone = std::max(place[i], place[j]);
                std::replace(place.begin(), place.end(), gone, kept);
            }
    uint places = 0;
    for (std::size_t i = 0; i < place.size(); ++i) places += place[i] == i;
    return places;
}

}  // namespace brandung
