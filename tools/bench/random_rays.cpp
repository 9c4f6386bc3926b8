#include "tools/bench/random_rays.h"

#include <cmath>
#include <limits>
#include <random>

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

std::vector<Bounds> boxes_of(const Scene &scene) {
    std::vector<Bounds> boxes;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) boxes.push_back(shape->bounds(i));
    for (const PlacedGroup &instance : scene.instances) boxes.push_back(instance.bounds);
    return boxes;
}

/// Makes rays for a list of boxes, of which there is one at least.
class RayMaker {
public:
    explicit RayMaker(std::vector<Bounds> boxes) : boxes_(std::move(boxes)) {
        for (const Bounds &box : boxes_) all_.add(box);
        const vec3 half = 0.5f * all_.high - 0.5f * all_.low;
        centre_ = all_.low + half, size_ = std::max({half.x, half.y, half.z, std::numeric_limits<float>::min()});
    }

    Ray make(std::size_t number) {
        vec3 origin = anywhere(), direction = random_direction();
        switch (number % 8) {
            case 0:
            case 1:
                from_afar(origin, direction);
                break;
            case 2:
                direction = along_axis(below(3));
                break;
            case 3:
                in_plane(origin, direction);
                break;
            case 4:
                through_corner(origin, direction);
                break;
            default:
                break;
        }
        return {.origin = origin, .t_max = below(4) == 0 ? 2 * size_ * unit() : infinity, .direction = direction, .tag = RAY_TAG(RAY_CAMERA, NO_HIT)};
    }

private:
    uint below(uint end) { return static_cast<uint>(engine_() % end); }
    float unit() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }
    float sign() { return below(2) ? 1.0f : -1.0f; }
    vec3 in_cube() { return {2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1}; }
    /// In a cube of twice the box's size.
    vec3 anywhere() { return centre_ + 2 * size_ * in_cube(); }
    vec3 random_direction() {
        while (true) {
            const vec3 d = in_cube();
            const float squared = glm::dot(d, d);
            if (squared > 0.01f && squared < 1) return d / std::sqrt(squared);
        }
    }
    vec3 along_axis(uint axis) {
        const float sign_of_all = sign();
        vec3 direction(std::copysign(0.0f, sign_of_all));
        direction[int(axis)] = sign_of_all;
        return direction;
    }
    const Bounds &box() { return boxes_[below(static_cast<uint>(boxes_.size()))]; }
    vec3 corner() {
        const Bounds &b = box();
        return {below(2) ? b.low.x : b.high.x, below(2) ? b.low.y : b.high.y, below(2) ? b.low.z : b.high.z};
    }
    void from_afar(vec3 &origin, vec3 &direction) {
        const vec3 target = centre_ + size_ * in_cube();
        origin = centre_ - 100 * size_ * direction;
        direction = glm::normalize(target - origin);
    }
    void in_plane(vec3 &origin, vec3 &direction) {
        const Bounds &b = box();
        const uint axis = below(3);
        if (below(2)) direction = along_axis((axis + 1) % 3);
        origin[int(axis)] = below(2) ? b.low[int(axis)] : b.high[int(axis)];
        direction[int(axis)] = std::copysign(0.0f, sign());
        direction = glm::normalize(direction);
    }
    void through_corner(vec3 &origin, vec3 &direction) {
        if (below(2)) direction = along_axis(below(3));
        origin = corner() - (below(2) ? 2 * size_ : 0.0f) * direction;
    }

    std::vector<Bounds> boxes_;
    Bounds all_;
    vec3 centre_{};
    float size_ = 0;  ///< half of the longest side of all
    std::mt19937 engine_{1};
};

}  // namespace

std::vector<RayQueue> random_rays(const Scene &scene, std::size_t count) {
    std::vector<Bounds> boxes = boxes_of(scene);
    RayQueue closest{RayQueue::Use::random, false, true, {}, std::vector<uint>(boxes.empty() ? 0 : count)};
    if (!boxes.empty()) {
        RayMaker maker(std::move(boxes));
        for (std::size_t i = 0; i < count; ++i) closest.rays.push_back(maker.make(i));
    }
    RayQueue shadows = closest;
    shadows.shadow = true;
    for (Ray &ray : shadows.rays) ray.tag = RAY_TAG(RAY_SHADOW, NO_HIT);
    return {std::move(closest), std::move(shadows)};
}

}  // namespace brandung
