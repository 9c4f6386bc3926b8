#include "scene/parameters.h"

#include <gtest/gtest.h>

#include "scene/error.h"

namespace brandung {
namespace {

Document document_of(const std::string &text) { return parse_document("scene.json", text); }

/// The message of the SceneError that `action` throws; empty if it throws none.
template <class Action> std::string error_of(Action action) {
    try {
        action();
    } catch (const SceneError &error) {
        return error.what();
    }
    return {};
}

std::string parse_error_of(const std::string &text) {
    return error_of([&] { document_of(text); });
}

/// The error of `action` on the object of a document's only member "a", which begins in line 2.
template <class Action> std::string error_at(const std::string &object, Action action) {
    const Document document = document_of("{\n\"a\": " + object + "}");
    return error_of([&] { action(Parameters(document, "/a")); });
}

TEST(Document, NamesFileLineAndCauseOfBadSyntax) {
    EXPECT_EQ(parse_error_of("{\n\"a\": 1,\n}").substr(0, 14), "scene.json:3: ");
    EXPECT_EQ(parse_error_of("{\n\"a\": NaN}").substr(0, 14), "scene.json:2: ");
    EXPECT_EQ(parse_error_of("{}\n{}").substr(0, 14), "scene.json:2: ");
    EXPECT_EQ(parse_error_of("\n{\"a\": \"x\n\"}").substr(0, 14), "scene.json:2: ");
    EXPECT_EQ(parse_error_of("").substr(0, 14), "scene.json:1: ");
}

TEST(Document, RefusesDuplicateKeysAtTheSecond) {
    EXPECT_EQ(parse_error_of("{\"a\": {\n\"b\": 1,\n\"c\": 2,\n\"b\": 3}}"), "scene.json:4: duplicate key \"b\"");
    EXPECT_EQ(parse_error_of("{\"a\": {\"b\": 1}, \"b\": 2}"), "");
}

TEST(Document, RefusesNumbersThatNoDoubleHolds) {
    EXPECT_NE(parse_error_of("{\n\"a\": 1e400}").find("scene.json:2: number overflow"), std::string::npos);
}

TEST(Document, RefusesEndlessNesting) {
    EXPECT_EQ(parse_error_of(std::string(100000, '[')), "scene.json:1: nested deeper than 64 levels");
    EXPECT_EQ(parse_error_of(std::string(64, '[') + std::string(64, ']')), "");
}

TEST(Document, ErrorsAreOneShortLine) {
    const std::string error = parse_error_of("{\"a\": \"" + std::string(5000, 'x') + "\n\x01\"}");
    EXPECT_LT(error.size(), 500u);
    EXPECT_EQ(error.find_first_of("\n\x01"), std::string::npos);
}

TEST(Document, NamesFilesThatCannotBeRead) {
    EXPECT_EQ(error_of([] { read_document("/no/such.json"); }), "/no/such.json: no such file");
    EXPECT_EQ(error_of([] { read_document("/tmp"); }), "/tmp: is a folder, not a file");
    EXPECT_EQ(error_of([] { read_document("/dev/null/x.json"); }), "/dev/null/x.json: no such file");
}

TEST(Document, AnErrorHasTheLineOfItsValue) {
    const Document document = document_of("{\"a\": [\n1,\n[2\n,\n3]],\n\"b/~\": {\n\"c\":\ntrue}}");
    const auto line_of = [&](const std::string &pointer) { return error_of([&] { fail_at(document, pointer, "why"); }); };
    EXPECT_EQ(line_of("/a"), "scene.json:1: /a: why");
    EXPECT_EQ(line_of("/a/0"), "scene.json:2: /a/0: why");
    EXPECT_EQ(line_of("/a/1/0"), "scene.json:3: /a/1/0: why");
    EXPECT_EQ(line_of("/a/1/1"), "scene.json:5: /a/1/1: why");
    EXPECT_EQ(line_of("/b~1~0"), "scene.json:6: /b~1~0: why");
    EXPECT_EQ(line_of("/b~1~0/c"), "scene.json:8: /b~1~0/c: why");
    EXPECT_EQ(line_of(""), "scene.json:1: why");
    // What is absent has the line of the innermost thing around it.
    EXPECT_EQ(line_of("/b~1~0/d/e"), "scene.json:6: /b~1~0/d/e: why");
}

TEST(SetValue, ReplacesAndMakesValues) {
    Document document = document_of(R"({"a": {"b": 1}, "c": [{"d": 2}, 3]})");
    for (const char *assignment : {"a.b=2.5", "c.0.d=[1, 2]", "c.1=true", "e.f=center", "g=a=b", "h=", "i=1.5.2"}) set_value(document, assignment);
    EXPECT_EQ(document.root,
              nlohmann::json::parse(R"({"a": {"b": 2.5}, "c": [{"d": [1, 2]}, true], "e": {"f": "center"}, "g": "a=b", "h": "", "i": "1.5.2"})"));
}

TEST(SetValue, RefusesPathsThatLeadNowhere) {
    Document document = document_of(R"({"a": 1, "b": [2]})");
    const auto error = [&](const char *assignment) { return error_of([&] { set_value(document, assignment); }); };
    EXPECT_EQ(error("a.x=1"), "scene.json: cannot set a.x=1: /a has no \"x\"");
    EXPECT_EQ(error("b.1=1"), "scene.json: cannot set b.1=1: /b has no \"1\"");
    EXPECT_EQ(error("b.-1=1"), "scene.json: cannot set b.-1=1: /b has no \"-1\"");
    EXPECT_EQ(error("b.0x=1"), "scene.json: cannot set b.0x=1: /b has no \"0x\"");
    EXPECT_EQ(error("c..d=1"), "scene.json: cannot set c..d=1: /c has no \"\"");
    EXPECT_EQ(error("spp"), "\"spp\": a setting has the form KEY=VALUE");
    EXPECT_EQ(error("=3"), "\"=3\": a setting has the form KEY=VALUE");
}

TEST(SetValue, ErrorsSayThatTheValueIsNotTheFiles) {
    Document document = document_of("{}");
    set_value(document, "a.b=-1");
    EXPECT_EQ(error_of([&] { Parameters(document, "/a").positive("b"); }), "scene.json: /a/b (set on the command line): must be positive, got -1");
}

TEST(SetValue, ErrorsOfOtherValuesStayTheFiles) {
    Document document = document_of("{\n\"a\": {\n\"c\": 1}}");
    set_value(document, "a.b=-1");
    set_value(document, "d.e=1");
    EXPECT_EQ(error_of([&] { fail_at(document, "", "why"); }), "scene.json:1: why");
    EXPECT_EQ(error_of([&] { fail_at(document, "/a", "why"); }), "scene.json:2: /a: why");
    EXPECT_EQ(error_of([&] { fail_at(document, "/a/c", "why"); }), "scene.json:3: /a/c: why");
    EXPECT_EQ(error_of([&] { fail_at(document, "/a/b/0", "why"); }), "scene.json: /a/b/0 (set on the command line): why");
    EXPECT_EQ(error_of([&] { fail_at(document, "/d", "why"); }), "scene.json: /d (set on the command line): why");
}

TEST(Parameters, GivesTypedValuesAndFallbacks) {
    const Document document =
        document_of(R"({"number": 1.5, "whole": 3.0, "yes": true, "text": "b", "vector": [1, 2, 3], "grey": 0.5, "red": [1, 0, 0],
        "vectors": [[1, 2, 3], [4, 5, 6]], "pairs": [[1, 2]], "integers": [4294967295, 0], "child": {"x": 1}, "children": [{"x": 1}, {"x": 2}]})");
    const Parameters root(document, "");
    EXPECT_EQ(root.number("number"), 1.5f);
    EXPECT_EQ(root.number("none", 7.0f), 7.0f);
    EXPECT_EQ(root.integer("whole"), 3u);
    EXPECT_TRUE(root.boolean("yes"));
    EXPECT_EQ(root.text("text"), "b");
    EXPECT_EQ(root.choice("text", {"a", "b"}), 1u);
    EXPECT_EQ(root.vector("vector"), vec3(1, 2, 3));
    EXPECT_EQ(root.spectrum("grey"), Spectrum(0.5f));
    EXPECT_EQ(root.spectrum("red"), Spectrum(1, 0, 0));
    EXPECT_EQ(root.vectors("vectors"), (std::vector<vec3>{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(root.pairs("pairs"), (std::vector<vec2>{{1, 2}}));
    EXPECT_EQ(root.integers("integers"), (std::vector<uint>{0xffffffffu, 0}));
    EXPECT_TRUE(root.texts("none").empty());
    EXPECT_EQ(root.child("child").number("x"), 1.0f);
    EXPECT_EQ(root.child("none").number("x", 2.0f), 2.0f);
    EXPECT_EQ(root.children("children").at(1).number("x"), 2.0f);
    root.expect_all_known();
}

TEST(Parameters, RefusesWrongTypes) {
    const std::string at = "scene.json:2: /a/x: must be ";
    EXPECT_EQ(error_at(R"({"x": "1"})", [](const auto &p) { p.number("x"); }), at + "a number, got \"1\"");
    EXPECT_EQ(error_at(R"({"x": null})", [](const auto &p) { p.number("x", 1.0f); }), at + "a number, got null");
    EXPECT_EQ(error_at(R"({"x": 1})", [](const auto &p) { p.boolean("x"); }), at + "true or false, got 1");
    EXPECT_EQ(error_at(R"({"x": {}})", [](const auto &p) { p.text("x"); }), at + "a text, got an object");
    EXPECT_EQ(error_at(R"({"x": 1})", [](const auto &p) { p.child("x"); }), at + "an object, got 1");
    EXPECT_EQ(error_at(R"({"x": {}})", [](const auto &p) { p.children("x"); }), at + "an array, got an object");
    EXPECT_EQ(error_at(R"({"x": [1]})", [](const auto &p) { p.children("x"); }), "scene.json:2: /a/x/0: must be an object, got 1");
    EXPECT_EQ(error_at(R"({"x": "c"})", [](const auto &p) { p.choice("x", {"a", "b"}); }), at + "one of a, b, got \"c\"");
    EXPECT_EQ(error_of([] { Parameters(document_of("[1]"), ""); }), "scene.json:1: must be an object, got an array of 1");
}

TEST(Parameters, RefusesWrongLengths) {
    EXPECT_EQ(error_at(R"({"x": [1, 2]})", [](const auto &p) { p.vector("x"); }),
              "scene.json:2: /a/x: must be an array of 3 numbers, got an array of 2");
    EXPECT_EQ(error_at(R"({"x": []})", [](const auto &p) { p.spectrum("x"); }),
              "scene.json:2: /a/x: must be a number or an array of 3 numbers, got an array of 0");
    EXPECT_EQ(error_at("{\"x\": [[1, 2, 3],\n[1, 2]]}", [](const auto &p) { p.vectors("x"); }),
              "scene.json:3: /a/x/1: must be an array of 3 numbers, got an array of 2");
    EXPECT_EQ(error_at("{\"x\": [[1, 2],\n[1,\n\"y\"]]}", [](const auto &p) { p.pairs("x"); }),
              "scene.json:4: /a/x/1/1: must be a number, got \"y\"");
}

TEST(Parameters, RefusesNumbersOutOfRange) {
    const std::string at = "scene.json:2: /a/x: must be ";
    EXPECT_EQ(error_at(R"({"x": 0})", [](const auto &p) { p.positive("x"); }), at + "positive, got 0");
    EXPECT_EQ(error_at(R"({"x": 1e-60})", [](const auto &p) { p.positive("x"); }), at + "positive, got 1e-60");
    EXPECT_EQ(error_at(R"({"x": -0.5})", [](const auto &p) { p.not_negative("x"); }), at + "not negative, got -0.5");
    EXPECT_EQ(error_at(R"({"x": [0, -1, 0]})", [](const auto &p) { p.spectrum("x"); }), "scene.json:2: /a/x/1: must be not negative, got -1");
    EXPECT_EQ(error_at(R"({"x": 1e39})", [](const auto &p) { p.spectrum("x"); }), at + "within the range of a float, got 1e+39");
    EXPECT_EQ(error_at(R"({"x": 1e30})", [](const auto &p) { p.spectrum("x"); }), "");
    EXPECT_EQ(error_at(R"({"x": -1.5e15})", [](const auto &p) { p.number("x"); }),
              at + "at most 1e15 in magnitude (its square must fit into a float with room to spare), got -1.5e+15");
    EXPECT_EQ(error_at(R"({"x": 1e15})", [](const auto &p) { p.number("x"); }), "");
    EXPECT_EQ(error_at(R"({"x": [1e16, 0, 0]})", [](const auto &p) { p.vector("x"); }).substr(0, 24), "scene.json:2: /a/x/0: mu");
}

TEST(Parameters, RefusesFractionsBeyondOne) {
    const auto read = [](const auto &p) { p.fraction("x"); };
    EXPECT_EQ(error_at(R"({"x": 1.5})", read), "scene.json:2: /a/x: must be at most 1, got 1.5");
    EXPECT_EQ(error_at(R"({"x": [0, 1, 2]})", read), "scene.json:2: /a/x/2: must be at most 1, got 2");
    EXPECT_EQ(error_at(R"({"x": 1})", read), "");
}

TEST(Parameters, RefusesWhatIsNoWholeNumberInRange) {
    const auto read = [](const Parameters &p) { p.integer("x", {}, 1, 100); };
    const std::string at = "scene.json:2: /a/x: must be a whole number from 1 to 100, got ";
    for (const char *bad : {"0", "101", "-1", "1.5", "1e300", "-9223372036854775808", "18446744073709551615", "\"1\"", "true"})
        EXPECT_EQ(error_at(std::string("{\"x\": ") + bad + "}", read).substr(0, at.size()), at) << bad;
    EXPECT_EQ(error_at(R"({"x": 1e2})", read), "");
}

TEST(Parameters, NamesWhatIsMissing) {
    EXPECT_EQ(error_at("{}", [](const auto &p) { p.number("radius"); }), "scene.json:2: /a: \"radius\" is missing");
    EXPECT_EQ(error_at(R"({"radios": 1})", [](const auto &p) { p.number("radius"); }),
              "scene.json:2: /a: \"radius\" is missing; \"radios\" is unknown");
    EXPECT_EQ(error_at(R"({"up": 1})", [](const auto &p) { p.number("at"); }), "scene.json:2: /a: \"at\" is missing") << "no likeness";
}

TEST(Parameters, RefusesUnknownKeysWithTheNearestKnownFirst) {
    const auto read = [](const Parameters &p) {
        p.number("center", 0.0f), p.number("material", 0.0f), p.number("radius", 0.0f);
        p.expect_all_known();
    };
    EXPECT_EQ(error_at("{\"center\": 1,\n\"raduis\": 2}", read), "scene.json:3: /a/raduis: unknown key; is \"radius\" meant?");
    EXPECT_EQ(error_at("{\"center\": 1,\n\"diameter\": 2}", read), "scene.json:3: /a/diameter: unknown key; known here: center, material, radius");
    EXPECT_EQ(error_at("{\"center\": 1}", read), "");
}

}  // namespace
}  // namespace brandung
