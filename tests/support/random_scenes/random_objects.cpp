/// Shapes and transforms of random scenes.
#include <array>

#include "tests/support/random_scenes/random_scene.h"

namespace brandung {
namespace {

using Json = nlohmann::ordered_json;
using Point = std::array<double, 3>;

/// Floats, so that what is written is what is read.
double rounded(double x) { return static_cast<double>(static_cast<float>(x)); }

/// A tenth of them on a grid, where things coincide.
Point point(Dice &dice, const RandomSpace &space, double reach) {
    const bool on_grid = dice.chance(10);
    Point p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = on_grid ? 0.25 * dice.below(9) - 1 : dice.uniform(-1, 1);
        p[axis] = rounded(space.offset[axis] + reach * space.unit * x);
    }
    return p;
}

double radius(Dice &dice, const RandomSpace &space) {
    const uint kind = dice.below(100);
    if (kind < 4) return 0;
    if (kind < 8) return rounded(space.unit * dice.power(-20, -6));
    if (kind < 10) return rounded(space.unit * dice.power(3, 10));
    return rounded(space.unit * dice.uniform(0.05, 0.9));
}

/// Now and then very near to another, or the same.
Point near(Dice &dice, const RandomSpace &space, const Point &other) {
    const uint kind = dice.below(100);
    if (kind < 4) return other;
    if (kind > 8) return point(dice, space, 1);
    RandomSpace small{space.unit * dice.power(-20, -6), {other[0], other[1], other[2]}};
    return point(dice, small, 1);
}

Json sphere(Dice &dice, const RandomSpace &space) { return {{"type", "sphere"}, {"center", point(dice, space, 1)}, {"radius", radius(dice, space)}}; }

Json disk(Dice &dice, const RandomSpace &space) {
    return {{"type", "disk"}, {"center", point(dice, space, 1)}, {"normal", random_direction(dice)}, {"radius", radius(dice, space)}};
}

Json frustum(Dice &dice, const RandomSpace &space) {
    const Point base = point(dice, space, 1);
    return {{"type", "frustum"},
            {"base", base},
            {"base_radius", radius(dice, space)},
            {"apex", near(dice, space, base)},
            {"apex_radius", dice.chance(30) ? 0 : radius(dice, space)}};
}

Json cylinder(Dice &dice, const RandomSpace &space) {
    const Point base = point(dice, space, 1);
    return {{"type", "cylinder"}, {"base", base}, {"apex", near(dice, space, base)}, {"radius", radius(dice, space)}};
}

Json uv(Dice &dice) { return {dice.uniform(-2, 2), dice.uniform(-2, 2)}; }

/// Triangles between few vertices, so that edges are shared, some twice, and some triangles are none.
Json triangle_mesh(Dice &dice, const RandomSpace &space) {
    const uint count = 3 + dice.below(6), triangles = 1 + dice.below(8);
    Json mesh = {{"type", "triangle_mesh"}, {"positions", Json::array()}, {"indices", Json::array()}};
    Point previous = point(dice, space, 1);
    for (uint i = 0; i < count; ++i) mesh["positions"].push_back(previous = near(dice, space, previous));
    for (uint i = 0; i < 3 * triangles; ++i) mesh["indices"].push_back(dice.below(count));
    const bool normals = dice.chance(40), uvs = dice.chance(40), colors = dice.chance(20);
    for (uint i = 0; i < count; ++i) {
        if (normals) mesh["normals"].push_back(random_direction(dice));
        if (uvs) mesh["uvs"].push_back(uv(dice));
        if (colors) mesh["colors"].push_back({dice.uniform(0, 1), dice.uniform(0, 1), dice.uniform(0, 2)});
    }
    return mesh;
}

/// Corners in one plane of two axes, or of all three, in any order: concave, crossing themselves, in one line.
Json polygon(Dice &dice, const RandomSpace &space) {
    const uint count = 3 + dice.below(5), axis = dice.below(3), bent = dice.chance(15);
    Json object = {{"type", "polygon"}, {"vertices", Json::array()}};
    const Point first = point(dice, space, 1);
    for (uint i = 0; i < count; ++i) {
        Point p = i == 0 ? first : point(dice, space, 1);
        if (!bent) p[axis] = first[axis];
        object["vertices"].push_back(p);
    }
    const bool normals = dice.chance(20), uvs = dice.chance(40);
    for (uint i = 0; i < count; ++i) {
        if (normals) object["normals"].push_back(random_direction(dice));
        if (uvs) object["uvs"].push_back(uv(dice));
    }
    return object;
}

Json matrix(Dice &dice, const RandomSpace &space) {
    Json numbers = Json::array();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            numbers.push_back(column == 3 ? space.unit * dice.uniform(-1, 1) : (row == column) + dice.uniform(-0.6, 0.6));
    return {{"matrix", numbers}};
}

/// Of a transform: turns by odd and by right angles, mirrors, stretches.
Json step(Dice &dice, const RandomSpace &space) {
    const uint kind = dice.below(6);
    if (kind == 0) return {{"translate", point(dice, {space.unit, {0, 0, 0}}, 1)}};
    if (kind == 1) return {{"scale", dice.chance(50) ? rounded(dice.uniform(0.3, 2)) : rounded(dice.uniform(-2, -0.3))}};
    if (kind == 2) return {{"scale", {dice.pick({-1.0, 1.0, 0.5}), dice.uniform(0.2, 2), dice.chance(10) ? dice.power(-12, 6) : 1.0}}};
    if (kind == 3) return {{"rotate", dice.pick({90.0, 180.0, 45.0, -30.0})}, {"axis", random_direction(dice)}};
    if (kind == 4) return {{"rotate", dice.uniform(-180, 180)}, {"axis", random_direction(dice)}};
    return matrix(dice, space);
}

}  // namespace

nlohmann::ordered_json random_point(Dice &dice, const RandomSpace &space, double reach) { return point(dice, space, reach); }

/// Along an axis now and then.
nlohmann::ordered_json random_direction(Dice &dice) {
    Point d = {0, 0, 0};
    if (dice.chance(20)) {
        d[dice.below(3)] = dice.pick({-1.0, 1.0});
        return d;
    }
    for (double &x : d) x = rounded(dice.uniform(-1, 1));
    if (d[0] == 0 && d[1] == 0 && d[2] == 0) d[0] = 1;
    return d;
}

nlohmann::ordered_json random_object(Dice &dice, const RandomSpace &space, uint materials) {
    Json object;
    const uint kind = dice.below(100);
    if (kind < 1) {
        object = {{"type", "mesh"}, {"file", "vase.obj"}};
        if (dice.chance(50)) return object;
    } else {
        using Make = Json (*)(Dice &, const RandomSpace &);
        object = dice.pick<Make>({sphere, sphere, disk, frustum, cylinder, triangle_mesh, triangle_mesh, polygon})(dice, space);
    }
    object["material"] = std::to_string(dice.below(materials));
    return object;
}

nlohmann::ordered_json random_transform(Dice &dice, const RandomSpace &space) {
    Json steps = Json::array();
    for (uint count = dice.below(4); count > 0; --count) steps.push_back(step(dice, space));
    return steps;
}

}  // namespace brandung
