#include "tests/images/spd_reference.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "tests/images/spd_file.h"

namespace spd {

Counts &Counts::operator+=(const Counts &other) {
    primary += other.primary, primary_hits += other.primary_hits;
    shadow += other.shadow, shadow_hits += other.shadow_hits;
    reflected += other.reflected, reflected_hits += other.reflected_hits;
    refracted += other.refracted, refracted_hits += other.refracted_hits;
    return *this;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr unsigned max_depth = 5;  ///< rays in a chain, the eye ray being 1
constexpr double offset = 1e-10;   ///< by which spawned rays start off the surface, relative to the scene's extent

// ---- crossings -------------------------------------------------------------------------------------------------------------------------------

struct Ray {
    Vec origin, direction;
    double start, end;  ///< crossings in (start, end) count
};

struct Candidate {
    double t = infinity;
    const Thing *thing = nullptr;
};

/// Two numbers s with a s² + 2 b s + c = 0, the smaller first.
bool quadratic(double a, double b, double c, double &first, double &second) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0 || a == 0) return false;
    const double root = std::sqrt(discriminant), q = b < 0 ? root - b : -root - b;
    first = q / a, second = q == 0 ? 0 : c / q;
    if (first > second) std::swap(first, second);
    return true;
}

/// Even and odd crossings of a half line with the outline.
bool inside(const Thing &thing, const Vec &p) {
    bool in = false;
    const double pu = p[thing.u], pv = p[thing.v];
    const std::size_t count = thing.corners.size();
    for (std::size_t i = 0, j = count - 1; i < count; j = i++) {
        const double au = thing.corners[i][thing.u], av = thing.corners[i][thing.v], bu = thing.corners[j][thing.u], bv = thing.corners[j][thing.v];
        if ((av > pv) != (bv > pv) && pu < (bu - au) * (pv - av) / (bv - av) + au) in = !in;
    }
    return in;
}

Vec geometric_normal(const Thing &thing, const Vec &p) {
    if (thing.kind == Kind::ball) return glm::normalize(p - thing.center);
    if (thing.kind == Kind::polygon) return thing.normal;
    const Vec f = p - thing.base;
    const Vec across = glm::normalize(f - glm::dot(f, thing.axis) * thing.axis);
    return glm::normalize(across - thing.slope * thing.axis);
}

/// The nearest crossing in the ray's range that counts, if `accept(t)` says so too.
template <class Accept> double cross(const Thing &thing, const Ray &ray, Accept accept) {
    double roots[2] = {infinity, infinity};
    if (thing.kind == Kind::polygon) {
        const double along = glm::dot(thing.normal, ray.direction);
        if (along == 0) return infinity;
        roots[0] = (thing.constant - glm::dot(thing.normal, ray.origin)) / along;
    } else if (thing.kind == Kind::ball) {
        const Vec f = ray.origin - thing.center;
        if (!quadratic(1, glm::dot(f, ray.direction), glm::dot(f, f) - thing.radius * thing.radius, roots[0], roots[1])) return infinity;
    } else {
        const Vec f = ray.origin - thing.base;
        const double fz = glm::dot(f, thing.axis), dz = glm::dot(ray.direction, thing.axis);
        const double r = thing.radius + thing.slope * fz, dr = thing.slope * dz;
        const double a = 1 - dz * dz - dr * dr, b = glm::dot(f, ray.direction) - fz * dz - r * dr, c = glm::dot(f, f) - fz * fz - r * r;
        if (!quadratic(a, b, c, roots[0], roots[1])) return infinity;
    }
    for (const double t : roots) {
        if (!(t > ray.start && t < ray.end)) continue;
        const Vec p = ray.origin + t * ray.direction;
        if (thing.kind == Kind::polygon && !inside(thing, p)) continue;
        if (thing.kind == Kind::cone) {
            const double z = glm::dot(p - thing.base, thing.axis);
            if (z < 0 || z > thing.height) continue;
        }
        if (accept(p)) return t;
    }
    return infinity;
}

// ---- boxes in boxes --------------------------------------------------------------------------------------------------------------------------

struct Box {
    Vec low{infinity}, high{-infinity};
    void add(const Vec &p) { low = glm::min(low, p), high = glm::max(high, p); }
    void add(const Box &other) { low = glm::min(low, other.low), high = glm::max(high, other.high); }
};

Box box_of(const Thing &thing) {
    Box box;
    if (thing.kind == Kind::ball) box.add(thing.center - thing.radius), box.add(thing.center + thing.radius);
    if (thing.kind == Kind::polygon)
        for (const Vec &corner : thing.corners) box.add(corner);
    if (thing.kind == Kind::cone) {
        const Vec apex = thing.base + thing.height * thing.axis;
        const double apex_radius = thing.radius + thing.slope * thing.height;
        box.add(thing.base - thing.radius), box.add(thing.base + thing.radius);
        box.add(apex - apex_radius), box.add(apex + apex_radius);
    }
    const Vec slack = 1e-9 * (1.0 + glm::max(glm::abs(box.low), glm::abs(box.high)));
    return {box.low - slack, box.high + slack};
}

struct Node {
    Box box;
    unsigned first, count;  ///< of things; count 0: children are `first` and `first` + 1
};

/// Halves by number along the longest side, until four are left.
class Tree {
public:
    explicit Tree(const std::vector<Thing> &things) {
        std::vector<Box> boxes;
        for (const Thing &thing : things) boxes.push_back(box_of(thing)), order_.push_back(&thing);
        std::vector<unsigned> indices(things.size());
        for (unsigned i = 0; i < indices.size(); ++i) indices[i] = i;
        nodes_.reserve(2 * things.size());
        nodes_.emplace_back();
        build(0, 0, static_cast<unsigned>(things.size()), boxes, indices);
        for (unsigned i = 0; i < indices.size(); ++i) order_[i] = &things[indices[i]];
    }

    /// The nearest crossing; with `any` the first that is found.
    template <class Accept> Candidate closest(Ray ray, bool any, Accept accept) const {
        Candidate best;
        const Vec inverse = 1.0 / ray.direction;
        unsigned stack[64], depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const Node &node = nodes_[stack[--depth]];
            if (!meets(node.box, ray, inverse)) continue;
            if (node.count == 0) {
                stack[depth++] = node.first, stack[depth++] = node.first + 1;
                continue;
            }
            for (unsigned i = node.first; i < node.first + node.count; ++i) {
                const Thing &thing = *order_[i];
                const double t = cross(thing, ray, [&](const Vec &p) { return accept(thing, p); });
                if (t >= ray.end || t == infinity) continue;
                best = {t, &thing}, ray.end = t;
                if (any) return best;
            }
        }
        return best;
    }

private:
    void build(unsigned node, unsigned first, unsigned end, const std::vector<Box> &boxes, std::vector<unsigned> &indices) {
        Box box, middles;
        for (unsigned i = first; i < end; ++i) box.add(boxes[indices[i]]), middles.add(boxes[indices[i]].low + boxes[indices[i]].high);
        nodes_[node] = {box, first, end - first};
        if (end - first <= 4) return;
        const Vec size = middles.high - middles.low;
        const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
        const unsigned half = (first + end) / 2;
        const auto before = [&](unsigned a, unsigned b) {
            return boxes[a].low[axis] + boxes[a].high[axis] < boxes[b].low[axis] + boxes[b].high[axis];
        };
        std::nth_element(indices.begin() + first, indices.begin() + half, indices.begin() + end, before);
        const auto children = static_cast<unsigned>(nodes_.size());
        nodes_[node].first = children, nodes_[node].count = 0;
        nodes_.emplace_back(), nodes_.emplace_back();
        build(children, first, half, boxes, indices);
        build(children + 1, half, end, boxes, indices);
    }

    static bool meets(const Box &box, const Ray &ray, const Vec &inverse) {
        double enter = ray.start, leave = ray.end;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (box.low[axis] - ray.origin[axis]) * inverse[axis], b = (box.high[axis] - ray.origin[axis]) * inverse[axis];
            enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
        }
        return enter <= leave * (1 + 1e-12);
    }

    std::vector<Node> nodes_;
    std::vector<const Thing *> order_;
};

/// The interpolated normal at p, a point of the triangle.
Vec patch_normal(const Thing &thing, const Vec &p) {
    const Vec &a = thing.corners[0], &b = thing.corners[1], &c = thing.corners[2];
    const double area = glm::dot(glm::cross(b - a, c - a), thing.normal);
    const double wa = glm::dot(glm::cross(b - p, c - p), thing.normal) / area, wb = glm::dot(glm::cross(c - p, a - p), thing.normal) / area;
    const Vec &na = thing.normals[0], &nb = thing.normals[1], &nc = thing.normals[2];
    return glm::normalize(wa * glm::normalize(na) + wb * glm::normalize(nb) + (1 - wa - wb) * glm::normalize(nc));
}

/// The outward normal for light at p, a point of the surface.
Vec shading_normal(const Thing &thing, const Vec &p, const Conventions &conventions) {
    if (!thing.normals.empty()) return patch_normal(thing, p);
    if (thing.kind != Kind::cone || !conventions.cone_normals_of_ratio) return geometric_normal(thing, p);
    const Vec f = p - thing.base, across = glm::normalize(f - glm::dot(f, thing.axis) * thing.axis);
    return glm::normalize(across - thing.slope * thing.height / thing.radius * thing.axis);
}

}  // namespace

// ---- counting --------------------------------------------------------------------------------------------------------------------------------

struct Reference::Implementation {
    explicit Implementation(const std::string &file) : scene(read(file)), tree(scene.things) {
        for (const Thing &thing : scene.things) {
            const Box box = box_of(thing);
            extent = std::max({extent, glm::length(box.low), glm::length(box.high)});
        }
    }

    /// Counts the rays that a hit spawns, and theirs.
    void shade(const Ray &ray, const Candidate &hit, unsigned depth, const Conventions &conventions, Counts &counts) const {
        const Thing &thing = *hit.thing;
        const Vec p = ray.origin + hit.t * ray.direction;
        const Vec outward = geometric_normal(thing, p);
        const bool enters = glm::dot(outward, ray.direction) < 0;
        const Vec geometric = enters ? outward : -outward;
        const Vec given = shading_normal(thing, p, conventions);
        const Vec normal = glm::dot(given, geometric) < 0 ? -given : given;
        const bool outside = conventions.lit == LitSide::outside_if_transparent && scene.surfaces.at(thing.surface).transmission > 0 && !enters;
        const Vec lit = conventions.lit == LitSide::as_given ? given : outside ? -normal : normal;
        for (const Vec &light : scene.lights)
            if (glm::dot(lit, light - p) > 0) send_to(light, p + offset * extent * (outside ? -geometric : geometric), conventions, counts);
        if (depth < max_depth) spawn(ray, thing, p, geometric, normal, depth, conventions, counts);
    }

    /// A shadow ray.
    void send_to(const Vec &light, const Vec &start, const Conventions &conventions, Counts &counts) const {
        const double distance = glm::length(light - start);
        const Ray ray{start, (light - start) / distance, 0, distance};
        const auto counted = [&](const Thing &thing, const Vec &p) {
            const bool polygon = thing.kind == Kind::polygon && thing.normals.empty();
            const double first = conventions.polygons_shade_from_zero && polygon ? 0 : conventions.start;
            return is_there(thing, p, ray, conventions) && glm::distance(start, p) > first;
        };
        counts.shadow += 1, counts.shadow_hits += tree.closest(ray, true, counted).thing != nullptr;
    }

    void spawn(const Ray &ray, const Thing &thing, const Vec &p, const Vec &geometric, const Vec &normal, unsigned depth,
               const Conventions &conventions, Counts &counts) const {
        const Surface &surface = scene.surfaces.at(thing.surface);
        const auto send = [&](const Vec &direction, std::uint64_t &rays, std::uint64_t &hits) {
            const Vec start = p + (glm::dot(direction, geometric) < 0 ? -offset : offset) * extent * geometric;
            rays += 1;
            hits += trace({start, glm::normalize(direction), conventions.start, infinity}, depth + 1, conventions, counts);
        };
        const auto folded = [&](const Vec &direction, const Vec &side) {
            const double behind = conventions.shading_normals_lead_inside ? 0 : std::max(0.0, -glm::dot(direction, side));
            return direction + 2 * behind * side;
        };
        const double projection = -glm::dot(ray.direction, normal), cosine = std::max(0.0, projection);
        const Vec mirrored = ray.direction + 2 * (conventions.shading_normals_lead_inside ? cosine : projection) * normal;
        if (surface.reflection > 0 || surface.transmission > 0) send(folded(mirrored, geometric), counts.reflected, counts.reflected_hits);
        if (surface.transmission == 0) return;
        const bool enters = glm::dot(geometric_normal(thing, p), ray.direction) < 0;
        const double eta = enters ? 1 / surface.index : surface.index, cosine_squared = 1 - eta * eta * (1 - cosine * cosine);
        if (cosine_squared < 0) {
            counts.refracted += conventions.total_reflection_refracts;
            return;
        }
        const Vec refracted = eta * ray.direction + (eta * cosine - std::sqrt(cosine_squared)) * normal;
        send(folded(refracted, -geometric), counts.refracted, counts.refracted_hits);
    }

    /// Whether the thing's surface at p has a side towards the ray's beginning.
    static bool is_there(const Thing &thing, const Vec &p, const Ray &ray, const Conventions &conventions) {
        return !conventions.one_sided_cones || thing.kind != Kind::cone || glm::dot(geometric_normal(thing, p), ray.direction) < 0;
    }

    /// Whether the ray hits anything.
    bool trace(const Ray &ray, unsigned depth, const Conventions &conventions, Counts &counts) const {
        const Candidate hit = tree.closest(ray, false, [&](const Thing &thing, const Vec &p) { return is_there(thing, p, ray, conventions); });
        if (hit.thing) shade(ray, hit, depth, conventions, counts);
        return hit.thing != nullptr;
    }

    Contents scene;
    Tree tree;
    double extent = 0;
};

Reference::Reference(const std::string &file) : implementation_(std::make_unique<Implementation>(file)) {}
Reference::~Reference() = default;

Counts Reference::count(unsigned width, unsigned height, Block block, const Conventions &conventions) const {
    const Contents &scene = implementation_->scene;
    const Vec forward = glm::normalize(scene.at - scene.from), right = glm::normalize(glm::cross(forward, scene.up)), up = glm::cross(right, forward);
    const double half_height = std::tan(glm::radians(scene.angle) / 2), half_width = half_height * width / height;
    Counts counts;
    for (unsigned y = block.y0; y < block.y1; ++y)
        for (unsigned x = block.x0; x < block.x1; ++x) {
            const double across = 2.0 * x / (width - 1) - 1, down = 2.0 * y / (height - 1) - 1;
            counts.primary += 1;
            const Ray ray{scene.from, glm::normalize(forward + across * half_width * right - down * half_height * up), 0, infinity};
            counts.primary_hits += implementation_->trace(ray, 1, conventions, counts);
        }
    return counts;
}

Counts Reference::count(unsigned width, unsigned height, const Conventions &conventions) const {
    std::atomic<unsigned> next = 0;
    std::vector<Counts> parts(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::thread> threads;
    for (Counts &part : parts)
        threads.emplace_back([&] {
            for (unsigned y = next++; y < height; y = next++) part += count(width, height, {0, y, width, y + 1}, conventions);
        });
    for (std::thread &thread : threads) thread.join();
    Counts counts;
    for (const Counts &part : parts) counts += part;
    return counts;
}

}  // namespace spd
