/// Disks.
#include "kernels/primitives/disk.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "scene/lights/light.h"
#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/primitives/kinds.h"

namespace brandung {

const PrimitiveKind disk_kind = {"disk", "Disk", sizeof(DiskBlock), true, false, 0};

namespace {

/// The greatest float that is at most center - size.
float rounded_down(double center, double size) {
    const double difference = center - size;
    const float rounded = float(difference);
    // Of what the difference of doubles has lost only the sign counts (Knuth, The Art of Computer Programming 2, 4.2.2).
    const double part = difference - center, lost = (center - (difference - part)) - (size + part);
    const bool is_above = rounded > difference || (rounded == difference && lost < 0);
    return is_above ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

/// The box of what the kernels take for the disk: about a normal whose length is 1 only but for rounding.
Bounds make_bounds(vec3 center, vec3 normal, float radius) {
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    const glm::dvec3 n(normal);
    Bounds bounds;
    for (int i = 0; i < 3; ++i) {
        const double across = std::hypot(n[(i + 1) % 3], n[(i + 2) % 3]) / std::hypot(n.x, n.y, n.z);
        const double size = n[i] == 0 ? radius : radius * across * (1 + rounding);
        bounds.low[i] = rounded_down(center[i], size);
        bounds.high[i] = -rounded_down(-double(center[i]), size);
    }
    return bounds;
}

class Disk final : public Shape {
public:
    Disk(uint material, vec3 center, vec3 normal, float radius)
        : Shape(material), center_(center), normal_(normal), radius_(radius), bounds_(make_bounds(center, normal, radius)) {}

    const PrimitiveKind &kind() const override { return disk_kind; }
    Bounds bounds(std::size_t) const override { return bounds_; }

    Hull hull(std::size_t) const override {
        Hull hull;
        hull.add({.center = center_, .radius = radius_, .axis = normal_});
        return hull;
    }

    void write_lane(std::size_t, uint lane, std::byte *block) const override {
        DiskBlock &disks = *reinterpret_cast<DiskBlock *>(block);
        for (int axis = 0; axis < 3; ++axis) {
            disks.center[axis][lane] = center_[axis];
            disks.normal[axis][lane] = normal_[axis];
            disks.low[axis][lane] = bounds_.low[axis];
            disks.high[axis][lane] = bounds_.high[axis];
        }
        disks.radius[lane] = radius_;
    }

    void write_shading(std::size_t, uint *words, SharedTables &) const override {
        const DiskShading shading = {center_, normal_, radius_};
        std::memcpy(words, &shading, sizeof shading);
    }

    std::vector<Light> light(uint cells, std::vector<EmissiveFace> &) const override {
        const double area = std::numbers::pi * radius_ * radius_;
        return make_cells(make_light(EmissiveDisk{{Spectrum(float(area)), {}, 0, 0}, center_, normal_, radius_}), cells);
    }

private:
    vec3 center_, normal_;
    float radius_;
    Bounds bounds_;
};

}  // namespace

std::unique_ptr<Shape> make_disk(uint material, vec3 center, vec3 normal, float radius) {
    if (radius == 0) return nullptr;
    return std::make_unique<Disk>(material, center, vec3(glm::normalize(glm::dvec3(normal))), radius);
}

void add_disk(Scene &scene, uint material, vec3 center, vec3 normal, float radius) {
    if (auto disk = make_disk(material, center, normal, radius)) {
        scene.shapes.push_back(std::move(disk));
    } else {
        ++scene.warnings["disk of radius 0: left out"];
    }
}

void read_disk(const Parameters &parameters, uint material, Scene &scene) {
    const vec3 center = parameters.vector("center"), normal = parameters.vector("normal");
    if (normal == vec3(0)) parameters.fail("normal", "must not be zero");
    add_disk(scene, material, center, normal, parameters.not_negative("radius"));
}

}  // namespace brandung
