/// Groups and instances in the native format.
#include <gtest/gtest.h>

#include "scene/compile.h"
#include "scene/error.h"
#include "tests/scene/formats/native_text.h"

namespace brandung {
namespace {

/// One object per line, so that an error's line says which.
const std::string text = R"({
"camera": {"from": [0, 0, 5], "at": [0, 0, 0]},
"materials": [{"name": "grey", "type": "whitted"}, {"name": "blue", "type": "whitted"}, {"name": "idle", "type": "whitted"}],
"groups": [
{"name": "ball", "objects": [{"type": "sphere", "material": "grey", "center": [1, 0, 0], "radius": 1}]},
{"name": "unused", "objects": [{"type": "cylinder", "material": "idle", "base": [0, 0, 0], "apex": [0, 1, 0], "radius": 1}]},
{"name": "empty", "objects": []}],
"objects": [
{"type": "instance", "group": "ball"},
{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1},
{"type": "instance", "group": "ball", "material": "blue", "transform": [{"scale": 2}, {"rotate": 90, "axis": [0, 0, 1]}, {"translate": [0, 0, 3]}]},
{"type": "instance", "group": "ball", "transform": {"matrix": [1, 0, 0, 4,  0, 0, -1, 5,  0, 1, 0, 6]}}]
})";

vec3 placed(const Transform &m, vec3 p) { return m.x * p.x + m.y * p.y + m.z * p.z + m.origin; }

TEST(Groups, AreReadWithTheirInstances) {
    const Scene scene = read_text(text);
    ASSERT_EQ(scene.groups.size(), 3u);
    EXPECT_EQ(scene.groups[0].name, "ball");
    EXPECT_EQ(scene.groups[0].shapes.size(), 1u);
    EXPECT_EQ(scene.shapes.size(), 1u) << "the group's objects are not the scene's";
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.instances[0].material, NO_MATERIAL);
    EXPECT_EQ(scene.instances[1].material, 1u);
    EXPECT_EQ(placed(scene.instances[0].transforms.to_world, {1, 2, 3}), vec3(1, 2, 3));
    EXPECT_EQ(placed(scene.instances[1].transforms.to_world, {1, 2, 3}), vec3(-4, 2, 9));
    EXPECT_EQ(placed(scene.instances[2].transforms.to_world, {1, 2, 3}), vec3(5, 2, 8));
    EXPECT_EQ(placed(scene.instances[2].transforms.to_group, {5, 2, 8}), vec3(1, 2, 3));
    // The sphere's box is [0, 2] x [-1, 1] x [-1, 1]; twice as large, turned and raised it is [-2, 2] x [0, 4] x [1, 5].
    const Bounds &bounds = scene.instances[1].bounds;
    EXPECT_NEAR(bounds.low.x, -2, 1e-4);
    EXPECT_NEAR(bounds.high.y, 4, 1e-4);
    EXPECT_NEAR(bounds.low.z, 1, 1e-4);
}

TEST(Groups, TakeMemoryOnceAndOnlyIfTheyAreUsed) {
    const CompiledScene compiled = compile(read_text(text));
    EXPECT_EQ(compiled.primitive_count, 2u);
    EXPECT_EQ(compiled.group_count, 1u);
    EXPECT_EQ(compiled.instance_count, 3u);
    EXPECT_EQ(compiled.primitives.size(), 1u) << "no cylinder is seen";
    Scene many = read_text(text);
    const std::size_t few_bytes = compile(many).arena.size();
    for (int i = 0; i < 10000; ++i) many.instances.push_back(many.instances[0]);
    // An instance takes 128 bytes, and an eighth of a block of 224, if that is full, and less of nodes; blocks may be half empty.
    EXPECT_LT(compile(many).arena.size(), few_bytes + 10000 * (128 + 224));
}

TEST(Groups, MaterialsThatInstancesReplaceAreNotInUse) {
    const std::string mirror = R"("name": "grey", "type": "whitted", "reflection": 1)";
    std::string replaced = text;
    replaced.replace(replaced.find(R"("name": "grey", "type": "whitted")"), 33, mirror);
    EXPECT_TRUE(compile(read_text(replaced)).reflects);
    const std::vector<std::string> all_blue = {"objects.0.material=blue", "objects.1.material=blue", "objects.3.material=blue"};
    EXPECT_FALSE(compile(read_text(replaced, all_blue)).reflects);
}

TEST(Groups, AnInstanceOfNothingIsLeftOutWithAWarning) {
    const Scene scene = read_text(text, {"objects.0.group=empty"});
    EXPECT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.warnings.at("instance of a group without surfaces: left out"), 1u);
}

/// The error's text behind the file's name, for the scene with `from` replaced by `to`.
std::string error_of(const std::string &from, const std::string &to) {
    std::string changed = text;
    EXPECT_NE(changed.find(from), std::string::npos) << from;
    return error_of_text(changed.replace(changed.find(from), from.size(), to));
}

TEST(Groups, ErrorsNameLineAndCause) {
    const std::string instance = R"({"type": "instance", "group": "ball"},)";
    const auto transform = [](const std::string &value) { return R"({"type": "instance", "group": "ball", "transform": )" + value + "},"; };
    const auto expect = [&](const std::string &from, const std::string &to, const std::string &error) { EXPECT_EQ(error_of(from, to), error) << to; };
    expect(instance, R"({"type": "instance", "group": "bell"},)", ":9: /objects/0/group: must be one of ball, unused, empty, got \"bell\"");
    expect(instance, R"({"type": "instance", "group": "ball", "material": "red"},)",
           ":9: /objects/0/material: must be one of grey, blue, idle, got \"red\"");
    expect(instance, R"({"type": "instance", "group": "ball", "center": [0, 0, 0]},)",
           ":9: /objects/0/center: unknown key; known here: type, group, material, transform");
    expect(instance, transform("3"), ":9: /objects/0/transform: must be an array, got 3");
    expect(instance, transform(R"([{"scale": 0}])"), ":9: /objects/0/transform/0/scale: must not be zero: nothing of the group would be left");
    expect(instance, transform(R"({"scale": [1, 0, 1]})"), ":9: /objects/0/transform/scale: must not be zero: nothing of the group would be left");
    expect(instance, transform(R"([{"translate": [0, 0, 0]}, {"rotate": 9, "axis": [0, 0, 0]}])"),
           ":9: /objects/0/transform/1/axis: must not be zero");
    expect(instance, transform(R"({"rotate": 9})"), ":9: /objects/0/transform: \"axis\" is missing");
    expect(instance, transform(R"({"scale": 2, "rotate": 9})"),
           ":9: /objects/0/transform: a step of a transform is one of translate, scale, rotate, matrix");
    expect(instance, transform("[{}]"), ":9: /objects/0/transform/0: a step of a transform is one of translate, scale, rotate, matrix");
    expect(instance, transform(R"({"scale": 2, "axis": [0, 1, 0]})"),
           ":9: /objects/0/transform/axis: unknown key; known here: matrix, scale, rotate, translate");
    expect(instance, transform(R"({"matrix": [1, 2, 3]})"), ":9: /objects/0/transform/matrix: must be an array of 12 numbers, got an array of 3");
    expect(instance, transform(R"({"matrix": [1,2,3,0, 4,5,6,0, 7,8,9,0]})"),
           ":9: /objects/0/transform: is singular, or it or its inverse has numbers beyond 1e15");
    expect(instance, transform(R"([{"scale": 1e10}, {"scale": 1e10}])"),
           ":9: /objects/0/transform: is singular, or it or its inverse has numbers beyond 1e15");
    expect(instance, transform(R"({"scale": 9e14})"), ":9: /objects/0/transform: places the group beyond 1e15");
    expect(R"("name": "unused")", R"("name": "ball")", ":6: /groups/1/name: \"ball\" is the name of an earlier one");
    expect(R"("objects": []})", R"("objects": [{"type": "instance", "group": "ball"}]})",
           ":7: /groups/2/objects/0/type: must be one of sphere, disk, frustum, cylinder, triangle_mesh, polygon, mesh, got \"instance\"");
    expect(R"("objects": []})", R"("things": []})", ":7: /groups/2/things: unknown key; known here: name, objects");
}

}  // namespace
}  // namespace brandung
