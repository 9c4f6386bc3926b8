/// Frusta of cones and cylinders, without caps.
#include "kernels/primitives/frustum.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "scene/lights/light.h"
#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/primitives/kinds.h"

namespace brandung {

const PrimitiveKind frustum_kind = {"frustum", "Frustum", sizeof(FrustumBlock), false, false, 0};

namespace {

/// What one lane of a FrustumBlock holds.
struct Record {
    vec3 center, axis;
    float half_length, radius, slope, side;
};

Record make_record(vec3 base, float base_radius, vec3 apex, float apex_radius) {
    const glm::dvec3 along = glm::dvec3(apex) - glm::dvec3(base);
    const double length = glm::length(along);
    const double at_base = std::abs(double(base_radius)), at_apex = std::abs(double(apex_radius));
    return {.center = vec3((glm::dvec3(base) + glm::dvec3(apex)) / 2.0),
            .axis = vec3(along / length),
            .half_length = float(length / 2),
            .radius = float((at_base + at_apex) / 2),
            .slope = float((at_apex - at_base) / length),
            .side = base_radius < 0 || apex_radius < 0 ? -1.0f : 1.0f};
}

float round_down(double x) {
    const float rounded = float(x);
    return rounded <= x ? rounded : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

/// The box of the two circles that bound what the record, as rounded, describes, and a few units in the last place of its corners more.
Bounds make_bounds(const Record &record) {
    const glm::dvec3 axis(record.axis);
    const double rise = std::abs(double(record.slope)) * record.half_length;  // also where rounding has made a tip negative
    Bounds bounds;
    for (int i = 0; i < 3; ++i) {
        // sqrt(1 - axis_i²) without its cancellation, for an axis whose length is 1 only but for rounding.
        const double across = std::hypot(axis[(i + 1) % 3], axis[(i + 2) % 3]) / glm::length(axis);
        const double shift = std::abs(axis[i]) * record.half_length;
        const double narrow = (record.radius - rise) * across, wide = (record.radius + rise) * across;
        const bool widens_upwards = (record.slope > 0) == (axis[i] > 0);
        const double above = widens_upwards ? shift + wide : std::max(shift + narrow, wide - shift);
        const double below = widens_upwards ? std::max(shift + narrow, wide - shift) : shift + wide;
        const double slack = 4 * std::numeric_limits<float>::epsilon() * (std::abs(double(record.center[i])) + shift + wide);
        bounds.low[i] = round_down(record.center[i] - below - slack);
        bounds.high[i] = -round_down(-(record.center[i] + above + slack));
    }
    return bounds;
}

class Frustum final : public Shape {
public:
    Frustum(uint material, const Record &record) : Shape(material), record_(record), bounds_(make_bounds(record)) {}

    const PrimitiveKind &kind() const override { return frustum_kind; }
    Bounds bounds(std::size_t) const override { return bounds_; }

    // The kernel takes for hits what rounding of its quadratic equation, some 2^-12 of the ray's way, leads past the surface, as long as it is in the
    // box: at thin cylinders, tips and flat cones that is more than a volume's margin.
    Hull hull(std::size_t) const override { return hull_of_box(bounds_); }

    void write_lane(std::size_t, uint lane, std::byte *block) const override {
        FrustumBlock &frusta = *reinterpret_cast<FrustumBlock *>(block);
        for (int axis = 0; axis < 3; ++axis) {
            frusta.center[axis][lane] = record_.center[axis];
            frusta.axis[axis][lane] = record_.axis[axis];
            frusta.low[axis][lane] = bounds_.low[axis];
            frusta.high[axis][lane] = bounds_.high[axis];
        }
        frusta.half_length[lane] = record_.half_length;
        frusta.radius[lane] = record_.radius;
        frusta.slope[lane] = record_.slope;
        frusta.side[lane] = record_.side;
    }

    void write_shading(std::size_t, uint *words, SharedTables &) const override {
        const FrustumShading shading = {record_.center, record_.axis, record_.radius, record_.slope, record_.half_length};
        std::memcpy(words, &shading, sizeof shading);
    }

    std::vector<Light> light(uint cells, std::vector<EmissiveFace> &) const override {
        const double half_length = record_.half_length, radius = record_.radius, rise = record_.slope * half_length;
        const double area = 4 * std::numbers::pi * radius * std::hypot(half_length, rise);
        return make_cells(make_light(EmissiveFrustum{
                              {Spectrum(float(area)), {}, 0, 0}, record_.center, record_.axis * record_.half_length, record_.radius, float(rise)}),
                          cells);
    }

private:
    Record record_;
    Bounds bounds_;
};

}  // namespace

std::unique_ptr<Shape> make_frustum(uint material, vec3 base, float base_radius, vec3 apex, float apex_radius) {
    constexpr float max_slope = 1e6f;  // flatter than this, it is a ring whose height floats cannot tell from 0
    if (base == apex || (base_radius == 0 && apex_radius == 0)) return nullptr;
    const Record record = make_record(base, base_radius, apex, apex_radius);
    if (!(std::abs(record.slope) <= max_slope && record.half_length > 0 && record.radius > 0)) return nullptr;
    return std::make_unique<Frustum>(material, record);
}

void add_frustum(Scene &scene, uint material, vec3 base, float base_radius, vec3 apex, float apex_radius) {
    if (auto frustum = make_frustum(material, base, base_radius, apex, apex_radius)) {
        scene.shapes.push_back(std::move(frustum));
    } else {
        ++scene.warnings["cone or cylinder without height or radius: left out"];
    }
}

void read_frustum(const Parameters &parameters, uint material, Scene &scene) {
    const vec3 base = parameters.vector("base"), apex = parameters.vector("apex");
    const float base_radius = parameters.not_negative("base_radius");
    add_frustum(scene, material, base, base_radius, apex, parameters.not_negative("apex_radius"));
}

void read_cylinder(const Parameters &parameters, uint material, Scene &scene) {
    const vec3 base = parameters.vector("base"), apex = parameters.vector("apex");
    const float radius = parameters.not_negative("radius");
    add_frustum(scene, material, base, radius, apex, radius);
}

}  // namespace brandung
