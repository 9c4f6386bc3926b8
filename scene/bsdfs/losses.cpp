#include "scene/bsdfs/losses.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "kernels/bsdfs/dielectric.h"
#include "scene/kinds.h"

namespace brandung {
namespace {

static_assert(offsetof(Dielectric, losses) == DIELECTRIC_LOSSES_WORD * sizeof(uint));

/// Of a lattice by Fibonacci's numbers in the unit square: with 32 x 32 in rows and columns, kinks at the critical angle err three times as much.
constexpr int points = 1597, generator = 987;

struct Facet {
    double z, along;  ///< its normal, along that of the surface and, in the surface, towards the light
    double weight;    ///< times the cosine of light at the facet: the area that light sees of it and its like
};

std::vector<Facet> facets_of(const Facets &facets) {
    std::vector<Facet> result;
    for (int i = 0; i < points; ++i) {
        const double azimuth = std::numbers::pi * (i * generator % points + 0.5) / points;
        const auto [z, radius, weight] = facet_slope(facets, (i + 0.5) / points);
        result.push_back({z, radius * std::cos(azimuth), weight / z});
    }
    return result;
}

/// Light at a cosine that meets a facet at another one.
class Meeting {
public:
    Meeting(const Facets &facets, double cosine, double area, double at_facet, double z)
        : facets_(facets), cosine_(cosine), area_(area), at_facet_(at_facet), z_(z), mirrored_(part(2 * at_facet * z - cosine)) {}

    /// Of what the facet mirrors and refracts, the part that no other facet meets.
    double part_that_leaves(double eta) const {
        const double sine_squared = (1 - at_facet_) * (1 + at_facet_), square = 1 - eta * eta * sine_squared;
        if (square <= 0) return mirrored_;
        const double beyond = std::sqrt(square), s = (eta * at_facet_ - beyond) / (eta * at_facet_ + beyond);
        const double p = (at_facet_ - eta * beyond) / (at_facet_ + eta * beyond), reflectance = (s * s + p * p) / 2;
        const double bend = std::sqrt((1 - eta) * (1 - eta) * sine_squared + (at_facet_ - beyond) * (at_facet_ - beyond)), x = 4.41 * bend;
        return reflectance * mirrored_ + (1 - reflectance) * part((beyond - eta * at_facet_) * z_ + eta * cosine_, x / (x + 1));
    }

private:
    /// Of light that goes on at this cosine, below 0 to where it meets the surface again. `apart`: masking_apart of kernels/bsdfs/dielectric.cl.
    double part(double cosine, double apart = 1) const {
        if (cosine <= 0) return 0;
        const double a = area_ * cosine, b = visible_area(facets_, std::min(cosine, 1.0)) * cosine_;
        return a / (std::max(a, b) + apart * (std::min(a, b) - cosine * cosine_));
    }

    const Facets &facets_;
    double cosine_, area_, at_facet_, z_, mirrored_;
};

/// Of the table's places, by side: where infinity would be, what differs from it by nothing.
std::vector<double> etas() {
    std::vector<double> result;
    for (const bool leaves : {false, true})
        for (int e = 0; e < LOSS_ETAS; ++e) {
            const double along = std::min(e / (LOSS_ETAS - 1.0), 1 - 1e-6), q = along / (1 - along) / 2, ratio = 1 + q * q;
            result.push_back(leaves ? ratio : 1 / ratio);
        }
    return result;
}

double cosine_at(double alpha, int place) {
    const double along = place / (LOSS_COSINES - 1.0);
    return std::min(alpha * along / (1 + alpha - along), 1.0);
}

/// The losses of light at a cosine, by eta.
std::vector<double> losses_at(const Facets &facets, const std::vector<Facet> &normals, const std::vector<double> &etas, double cosine) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine)), area = visible_area(facets, cosine);
    std::vector<double> losses(etas.size());
    double seen = 0;
    for (const Facet &normal : normals) {
        const double at_facet = std::min(normal.along * sine + normal.z * cosine, 1.0), weight = normal.weight * at_facet;
        if (at_facet <= 0) continue;
        const Meeting meeting(facets, cosine, area, at_facet, normal.z);
        seen += weight;
        for (std::size_t e = 0; e < etas.size(); ++e) losses[e] += weight * (1 - meeting.part_that_leaves(etas[e]));
    }
    for (double &loss : losses) loss = std::max(loss / seen, 0.0);  // rounding
    return losses;
}

/// Of what kernels see between the places: the integral of it times 2 z, which is exact. ∫ 2 z x dz of x = z (1 + alpha) / (z + alpha) is `of_place`.
float mean_of(const LossRow &row, double alpha) {
    const auto of_place = [&](double z) { return (1 + alpha) * (z * z - 2 * alpha * z + 2 * alpha * alpha * std::log1p(z / alpha)); };
    double sum = 0;
    for (int k = 0; k + 1 < LOSS_COSINES; ++k) {
        const double z = cosine_at(alpha, k), next = cosine_at(alpha, k + 1), step = 1 / (LOSS_COSINES - 1.0);
        const double all = next * next - z * z, rising = (of_place(next) - of_place(z)) / step - k * all;
        sum += double(row.at[k]) * (all - rising) + double(row.at[k + 1]) * rising;
    }
    return static_cast<float>(sum);
}

}  // namespace

LossTable loss_table_of(const Facets &facets) {
    const std::vector<Facet> normals = facets_of(facets);
    const std::vector<double> all = etas();
    LossTable table;
    LossRow *rows = table.rows[0];
    tbb::parallel_for(0, LOSS_COSINES, [&](int column) {
        const std::vector<double> losses = losses_at(facets, normals, all, cosine_at(facets.alpha, column));
        for (std::size_t e = 0; e < all.size(); ++e) rows[e].at[column] = static_cast<float>(losses[e]);
    });
    for (std::size_t e = 0; e < all.size(); ++e) rows[e].mean = mean_of(rows[e], facets.alpha);
    return table;
}

std::vector<std::byte> with_losses(std::vector<Material> materials, const std::vector<bool> &is_used, bool computes) {
    std::vector<Facets> facets;
    std::map<std::pair<float, uint>, std::size_t> places;
    for (std::size_t m = 0; m < is_used.size(); ++m) {
        if (!is_used[m] || (materials[m].flags & MATERIAL_LOSES) == 0) continue;
        auto view = view_of<Dielectric>(materials[m].words);
        const auto [place, is_new] = places.try_emplace({view.alpha, view.distribution}, facets.size());
        if (is_new) facets.push_back({view.alpha, view.distribution});
        const std::size_t bytes = (materials.size() - m) * sizeof(Material) - offsetof(Material, words) + place->second * sizeof(LossTable);
        view.losses = static_cast<uint>(bytes / sizeof(uint));
        write_words(view, materials[m].words);
    }
    std::vector<LossTable> tables(facets.size());
    if (computes) tbb::parallel_for(std::size_t{0}, tables.size(), [&](std::size_t t) { tables[t] = loss_table_of(facets[t]); });
    std::vector<std::byte> records;
    const auto add = [&](std::span<const std::byte> bytes) { records.insert(records.end(), bytes.begin(), bytes.end()); };
    add(std::as_bytes(std::span(materials))), add(std::as_bytes(std::span(tables)));
    return records;
}

}  // namespace brandung
