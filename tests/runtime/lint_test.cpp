/// What lint sees is what scenes can use.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "runtime/wavefront/specialization.h"
#include "tests/runtime/scenes_in_use.h"

namespace brandung {
namespace {

/// The lines of a generated file that hold a list, sorted by content: kinds are numbered by their scene.
std::set<std::string> listed_names(const std::string &text) {
    std::set<std::string> names;
    static const std::regex entry(R"(X\(\d+, (\w+), (\w+)\))"), include(R"re(#include "([^"]+)")re");
    for (auto match = std::sregex_iterator(text.begin(), text.end(), entry); match != std::sregex_iterator(); ++match)
        names.insert((*match)[1].str() + " " + (*match)[2].str());
    for (auto match = std::sregex_iterator(text.begin(), text.end(), include); match != std::sregex_iterator(); ++match) names.insert((*match)[1]);
    return names;
}

std::string stub_of(const std::filesystem::path &path) {
    std::ifstream in(path);
    EXPECT_TRUE(in) << path << " is not there for lint";
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(Lint, ItsListsNameEveryKindAndFileThatSpecialisationCanMake) {
    const std::filesystem::path stubs = BRANDUNG_SOURCE_DIR "/tests/kernels/all_kinds", of_one_lane = BRANDUNG_SOURCE_DIR "/tests/kernels/one_lane";
    Scene scene = everything();
    auto world = std::exchange(scene.shapes, {});
    add_soup(scene, 0, {.of_each = 1});
    add_group(scene, "group", std::exchange(scene.shapes, std::move(world)));
    ASSERT_FALSE(add_instance(scene, 0, AffineMap(), add_material(scene, emitter(Spectrum(1)))));
    const CompiledScene compiled = compile(scene, {.kinds = Kinds::all});
    const Sources lists = specialize(compiled, RayLanes::eight);
    for (const auto &[path, text] : specialize(compiled, RayLanes::one)) {
        if (text == lists.at(path)) continue;
        EXPECT_EQ(listed_names(stub_of(of_one_lane / path)), listed_names(text)) << path;
    }
    for (const auto &[path, text] : lists) {
        const std::string stub = stub_of(stubs / path);
        EXPECT_EQ(listed_names(stub), listed_names(text)) << path;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("#define ")) {
                const std::string name = line.substr(0, line.find_first_of(" (", 8));
                EXPECT_NE(stub.find(name), std::string::npos) << path << ": " << name;
            }
    }
    const std::set<std::string> of_others = {"generated/camera.cl", "generated/kind.cl", "generated/precision.cl"};  // not of the scene
    for (const auto &file : std::filesystem::recursive_directory_iterator(stubs)) {
        const std::string name = std::filesystem::relative(file.path(), stubs).string();
        EXPECT_TRUE(!file.is_regular_file() || lists.contains(name) || of_others.contains(name)) << name << " stands for nothing";
    }
}

}  // namespace brandung
