/// Spheres.
#include "kernels/primitives/sphere.h"

#include <cmath>
#include <cstring>

#include "scene/lights/light.h"
#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/primitives/kinds.h"

namespace brandung {

const PrimitiveKind sphere_kind = {"sphere", "Sphere", sizeof(SphereBlock), false, false, 0};

namespace {

class Sphere final : public Shape {
public:
    Sphere(uint material, vec3 center, float radius) : Shape(material), center_(center), radius_(radius) {}

    const PrimitiveKind &kind() const override { return sphere_kind; }

    // In float, rounded to nearest: the kernel computes the same box.
    Bounds bounds(std::size_t) const override {
        const float r = std::abs(radius_);
        return {center_ - r, center_ + r};
    }

    Hull hull(std::size_t) const override {
        Hull hull;
        hull.add({.center = center_, .radius = std::abs(radius_)});
        return hull;
    }

    void write_lane(std::size_t, uint lane, std::byte *block) const override {
        SphereBlock &spheres = *reinterpret_cast<SphereBlock *>(block);
        spheres.x[lane] = center_.x, spheres.y[lane] = center_.y, spheres.z[lane] = center_.z;
        spheres.radius[lane] = radius_;
    }

    void write_shading(std::size_t, uint *words, SharedTables &) const override {
        const SphereShading shading = {center_, radius_};
        std::memcpy(words, &shading, sizeof shading);
    }

    std::vector<Light> light(uint cells, std::vector<EmissiveFace> &) const override {
        return make_cells(make_light(EmissiveSphere{{Spectrum(1), {}, 0, 0}, center_, std::abs(radius_)}), cells);
    }

private:
    vec3 center_;
    float radius_;
};

}  // namespace

std::unique_ptr<Shape> make_sphere(uint material, vec3 center, float radius) {
    if (radius == 0) return nullptr;
    return std::make_unique<Sphere>(material, center, radius);
}

void add_sphere(Scene &scene, uint material, vec3 center, float radius) {
    if (auto sphere = make_sphere(material, center, radius)) {
        scene.shapes.push_back(std::move(sphere));
    } else {
        ++scene.warnings["sphere of radius 0: left out"];
    }
}

void read_sphere(const Parameters &parameters, uint material, Scene &scene) {
    const vec3 center = parameters.vector("center");
    add_sphere(scene, material, center, parameters.not_negative("radius"));
}

}  // namespace brandung
