/// Motions between keys, the polynomials that kernels have of them, and the bounds of what moves.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/compile.h"
#include "scene/error.h"
#include "scene/formats/format.h"
#include "scene/motion_parts.h"
#include "scene/primitives/add.h"
#include "scene/view.h"
#include "tests/scene/formats/temporary_file.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

constexpr Shutter second = {0, 1};
const Bounds thin_box = {{-3, -0.01f, -0.02f}, {3, 0.01f, 0.02f}};

glm::dvec3 applied(const AffineMap &map, const glm::dvec3 &p) { return map.linear * p + map.offset; }

/// What a kernel does, in double.
AffineMap value_of(const Transform (&terms)[MOTION_TERMS], double s) {
    AffineMap map{glm::dmat3(0), glm::dvec3(0)};
    for (int k = 3; k >= 0; --k) {
        map.linear = s * map.linear + glm::dmat3(glm::dvec3(terms[k].x), glm::dvec3(terms[k].y), glm::dvec3(terms[k].z));
        map.offset = s * map.offset + glm::dvec3(terms[k].origin);
    }
    return map;
}

struct Moment {
    AffineMap to_world, to_group;
    const MotionPart *part;
};

Moment moment_of(const std::vector<MotionPart> &parts, double time) {
    auto part = parts.begin();
    while (part + 1 != parts.end() && double((part + 1)->begin) <= time) ++part;
    const double s = std::clamp((time - double(part->begin)) * double(part->rate), 0.0, 1.0);
    return {value_of(part->to_world, s), value_of(part->to_group, s), &*part};
}

AffineMap random_map(Random &random, bool mirrors) {
    const AffineMap stretch = scaling({random.uniform(0.3f, 2), random.uniform(0.3f, 2), random.uniform(0.3f, 2) * (mirrors ? -1 : 1)});
    const AffineMap turned =
        then(rotation(random.uniform(0, 360), random.direction()), then(stretch, rotation(random.uniform(0, 360), random.direction())));
    return then(turned, translation(random.in_cube(5)));
}

glm::dvec3 point_in(const Bounds &bounds, Random &random) {
    const auto between = [&](int axis) { return random.uniform(bounds.low[axis], bounds.high[axis]); };
    return {between(0), between(1), between(2)};
}

}  // namespace

TEST(Motion, StaysAtItsEndsAndGoesThroughItsKeysExactly) {
    const AffineMap a = translation({1, 2, 3}), b = rotation(30, {1, 1, 0}), c = scaling({2, 3, 4});
    const Motion motion({{1, a}, {2, b}, {4, c}});
    EXPECT_FALSE(motion.fault());
    EXPECT_EQ(motion.at(0), a);
    EXPECT_EQ(motion.at(1), a);
    EXPECT_EQ(motion.at(2), b);
    EXPECT_EQ(motion.at(4), c);
    EXPECT_EQ(motion.at(9), c);
    EXPECT_TRUE(motion.is_at_rest({-1, 1}));
    EXPECT_TRUE(motion.is_at_rest({1.5, 1.5}));
    EXPECT_FALSE(motion.is_at_rest({0, 1.5}));
}

/// 60 of 180 degrees after a third of the time, half way along and half as much larger.
TEST(Motion, TurnsEvenlyStretchesEvenlyAndGoesStraight) {
    const Motion turning({{0, AffineMap()}, {3, rotation(90, {0, 0, 1})}});
    const glm::dvec3 turned = applied(turning.at(1), {1, 0, 0});
    EXPECT_NEAR(turned.x, std::cos(glm::radians(30.0)), 1e-15);
    EXPECT_NEAR(turned.y, std::sin(glm::radians(30.0)), 1e-15);
    const Motion growing({{0, translation({0, 0, 0})}, {2, then(scaling({3, 1, 1}), translation({4, 0, 0}))}});
    EXPECT_NEAR(applied(growing.at(1), {1, 0, 0}).x, 2 + 2, 1e-14);
    const Motion mirrored({{0, scaling({-1, 1, 1})}, {1, then(scaling({-1, 1, 1}), rotation(60, {0, 0, 1}))}});
    EXPECT_FALSE(mirrored.fault());
    EXPECT_NEAR(applied(mirrored.at(0.5), {1, 0, 0}).x, -std::cos(glm::radians(30.0)), 1e-14);
}

TEST(Motion, PolynomialsAreWithinAMillionthAndNearlyInverse) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const bool mirrors = i % 2 != 0;
        const Motion motion({{0, random_map(random, mirrors)}, {0.3, random_map(random, mirrors)}, {1, random_map(random, mirrors)}});
        ASSERT_FALSE(motion.fault());
        const auto parts = motion_parts(motion, second, {vec3(-1), vec3(1)});
        ASSERT_TRUE(parts);
        for (int k = 0; k <= 100; ++k) {
            const double time = k / 100.0;
            const glm::dvec3 p = random.in_cube(1), wanted = applied(motion.at(time), p);
            const Moment moment = moment_of(*parts, time);
            const glm::dvec3 there = applied(moment.to_world, p);
            ASSERT_LT(glm::length(there - wanted), 2e-6 * (glm::length(wanted) + 5)) << time;
            const Transform &m = moment.part->mismatch;
            const glm::dvec3 size = glm::abs(p),
                             most = glm::dvec3(m.x) * size.x + glm::dvec3(m.y) * size.y + glm::dvec3(m.z) * size.z + glm::dvec3(m.origin);
            const glm::dvec3 error = glm::abs(applied(moment.to_group, there) - p);
            for (int axis = 0; axis < 3; ++axis) ASSERT_LE(error[axis], most[axis]) << time;
            ASSERT_LT(glm::length(most), 3e-4) << "a bound that tells something";
        }
    }
}

/// None of its points leaves the bounds, and these are hardly larger than they must be.
TEST(Motion, BoundsHoldAThinBoxThatTurns) {
    Random random(2);
    const Motion motion({{0, translation({7, 0, 0})}, {1, then(rotation(90, {0, 0, 1}), translation({7, 0, 0}))}});
    const auto parts = motion_parts(motion, second, thin_box);
    ASSERT_TRUE(parts);
    const Bounds bounds = bounds_in_world(*parts, thin_box);
    Bounds seen;
    for (int i = 0; i < 20000; ++i) {
        const double time = double(random.uniform(0, 1));
        for (uint corner = 0; corner < 8; ++corner) {
            const vec3 p = {(corner & 1 ? thin_box.high : thin_box.low).x, (corner & 2 ? thin_box.high : thin_box.low).y,
                            (corner & 4 ? thin_box.high : thin_box.low).z};
            for (const AffineMap &map : {motion.at(time), moment_of(*parts, time).to_world}) seen.add(vec3(applied(map, glm::dvec3(p))));
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(bounds.low[axis], seen.low[axis]);
        EXPECT_GE(bounds.high[axis], seen.high[axis]);
    }
    EXPECT_NEAR(bounds.high.y, 3, 0.02) << "where it has turned to the end";
    EXPECT_NEAR(bounds.low.x, 4, 0.02) << "where it begins";
    EXPECT_NEAR(bounds.high.z, 0.02, 1e-4);
}

TEST(Motion, BoundsHoldWhatRandomMotionsMove) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const Motion motion({{0, random_map(random, false)}, {1, random_map(random, false)}});
        const auto parts = motion_parts(motion, second, thin_box);
        ASSERT_TRUE(parts);
        const Bounds bounds = bounds_in_world(*parts, thin_box);
        for (int k = 0; k < 300; ++k) {
            const glm::dvec3 p = applied(moment_of(*parts, double(random.uniform(0, 1))).to_world, point_in(thin_box, random));
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_LE(double(bounds.low[axis]), p[axis]);
                ASSERT_GE(double(bounds.high[axis]), p[axis]);
            }
        }
    }
}

TEST(Motion, OneThatIsSingularSomewhereIsRefused) {
    const auto fault = [](const AffineMap &a, const AffineMap &b) { return Motion({{0, a}, {1, b}}).fault().value_or("none"); };
    EXPECT_EQ(fault(scaling({1, 1, 1}), scaling({-1, 1, 1})), "becomes singular between times 0 and 1: it mirrors at one of them only");
    EXPECT_EQ(fault(AffineMap(), {{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {}}), "is singular at time 1, or it or its inverse has numbers beyond 1e15");
    EXPECT_EQ(fault(scaling({1, 1, 1}), scaling({-1, -1, 1})), "none") << "half a turn";
    EXPECT_EQ(fault(scaling({1, 1, 1}), scaling({1e-6, 1e-6, 1e-6})), "none");
}

namespace {

const std::string text = R"({"integrator": {"type": "path"},
"camera": {"from": [0, 0, 5], "at": [0, 0, 0], "shutter": [0, 1]},
"materials": [{"name": "grey", "type": "diffuse"}],
"groups": [{"name": "ball", "objects": [{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1}]}],
"objects": [{"type": "instance", "group": "ball", "transform": [
    {"time": 0},
    {"time": 2, "transform": {"translate": [4, 0, 0]}}]}]
})";

std::string error_of(const std::string &from, const std::string &to) {
    std::string changed = text;
    EXPECT_NE(changed.find(from), std::string::npos) << from;
    const TemporaryFile file(changed.replace(changed.find(from), from.size(), to));
    try {
        const Scene scene = read_scene(file.path);
        compile(scene);
    } catch (const SceneError &error) {
        return std::string(error.what()).substr(file.path.size());
    }
    return {};
}

}  // namespace

TEST(MotionFormat, KeysOfInstancesAreReadAsFarAsTheShutterIsOpen) {
    const Scene scene = read_text(text);
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].motion.size(), 1u) << "a translation is a polynomial";
    EXPECT_NEAR(scene.instances[0].bounds.low.x, -1, 1e-4);
    EXPECT_NEAR(scene.instances[0].bounds.high.x, 3, 1e-4) << "half way";
    EXPECT_EQ(scene.instances[0].transforms.to_world.origin, vec3(0));
    const Scene instant = read_text(text, {"camera.shutter=[1,1]"});
    EXPECT_TRUE(instant.instances[0].motion.empty());
    EXPECT_EQ(instant.instances[0].transforms.to_world.origin, vec3(2, 0, 0));
    EXPECT_TRUE(read_text(text, {"camera.shutter=[2,3]"}).instances[0].motion.empty()) << "it has come to rest";
    EXPECT_EQ(read_text(text, {"camera.shutter=[2,3]"}).instances[0].transforms.to_world.origin, vec3(4, 0, 0));
    EXPECT_TRUE(compile(scene).moves);
    EXPECT_FALSE(compile(instant).moves);
}

TEST(MotionFormat, CamerasMoveByKeysUnlessAnOptionSaysWhereTheyStand) {
    const std::string keys = R"(camera.keys=[{"time":0},{"time":1,"from":[1,0,5],"at":[1,0,0]}])";
    const Scene moving = read_text(text, {keys});
    ASSERT_EQ(moving.cameras[0].keys.size(), 2u);
    EXPECT_EQ(moving.cameras[0].keys[1].from, vec3(1, 0, 5));
    EXPECT_EQ(moving.cameras[0].keys[1].up, vec3(0, 1, 0));
    const Scene instant = read_text(text, {keys, "camera.shutter=[1,1]"});
    EXPECT_TRUE(instant.cameras[0].keys.empty());
    EXPECT_EQ(instant.cameras[0].from, vec3(1, 0, 5));
    CameraDescription camera = moving.cameras[0];
    ViewChanges{.from = vec3(0, 1, 4), .at = {}, .up = {}, .fov = {}}.apply(camera);
    EXPECT_TRUE(camera.keys.empty());
    EXPECT_EQ(camera.at, vec3(0));
}

TEST(MotionFormat, ErrorsNameLineAndCause) {
    const auto expect = [](const std::string &from, const std::string &to, const std::string &error) { EXPECT_EQ(error_of(from, to), error) << to; };
    expect("\"shutter\": [0, 1]", "\"shutter\": [1, 0]", ":2: /camera/shutter: must not close before it opens");
    expect("\"shutter\": [0, 1]", "\"shutter\": 1", ":2: /camera/shutter: must be an array of 2 numbers, got 1");
    expect("\"time\": 2", "\"time\": 0", ":7: /objects/0/transform/1/time: must be later than that of the key before");
    expect("\"time\": 2, \"transform\"", "\"transform\"", ":7: /objects/0/transform/1: \"time\" is missing");
    expect("\"translate\": [4, 0, 0]", "\"scale\": [-1, 1, 1]",
           ":5: /objects/0/transform: becomes singular between times 0 and 2: it mirrors at one of them only");
    expect("{\"time\": 0},\n", "", ":5: /objects/0/transform: needs at least two keys, or none");
    expect("\"time\": 0}", "\"time\": 0, \"spin\": 3}", ":6: /objects/0/transform/0/spin: unknown key; known here: time, transform");
    expect("\"shutter\": [0, 1]", "\"shutter\": [0, 1], \"keys\": [{\"time\": 0}]", ":2: /camera/keys: needs at least two keys, or none");
    expect("\"shutter\": [0, 1]", "\"shutter\": [0, 1], \"keys\": [{\"time\": 0}, {\"time\": 1, \"at\": [0, 0, 5]}]",
           ":2: /camera/keys/1/at: must differ from \"from\"");
    expect("\"shutter\": [0, 1]", "\"shutter\": [0, 1], \"keys\": [{\"time\": 0.5}, {\"time\": 0.50000006, \"at\": [4, 0, 7]}]",
           ":2: /camera/keys: the camera changes too much between its keys");
}

}  // namespace brandung
