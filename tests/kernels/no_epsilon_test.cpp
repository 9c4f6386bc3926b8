/// What kernels must not contain: epsilons that rays begin or end at, and library functions whose results differ from device to device.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "runtime/opencl/embedded_kernels.h"
#include "runtime/opencl/source.h"

namespace brandung {
namespace {

std::string without_comments(const std::string &text) { return std::regex_replace(text, std::regex(R"(//[^\n]*)"), ""); }

/// Whether a line has what is looked for.
using Search = bool (*)(const std::string &line);

/// Lines that the search finds, as "file:line: text".
std::vector<std::string> offences(const std::string &file, const std::string &text, Search search) {
    std::vector<std::string> found;
    std::istringstream lines(without_comments(text));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
        if (search(line)) found.push_back(file + ":" + std::to_string(number) + ": " + line);
    return found;
}

std::vector<std::string> offences(Search search) {
    std::vector<std::string> found;
    for (const EmbeddedFile &file : embedded_kernels())
        for (std::string &line : offences(std::string(file.path), std::string(file.text), search)) found.push_back(std::move(line));
    return found;
}

/// A distance along a ray (t, t0, hit.t, t_max, near, far, entry ...) compared with a number that is not 0; or something called epsilon.
bool has_epsilon(const std::string &line) {
    static const std::string distance = R"(\b(?:t[01]?|t_min|t_max|near|far|nearest|enter|entry|entered|distance)(?:\[\w+\])?)";
    static const std::string number = R"((?:\(\w+\)\s*\()?-?((?:0x[\da-f.]+p[+-]?\d+|\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?))[fu]?\)?)";
    static const std::regex named(R"(epsilon|\beps\b)", std::regex::icase);
    static const std::regex before(R"((?:^|[^\w.]))" + number + R"(\s*[<>]=?\s*(?:\w+(?:\.|->))*)" + distance);
    static const std::regex after(distance + R"(\s*[<>]=?\s*)" + number);
    if (std::regex_search(line, named)) return true;
    for (const std::regex *pattern : {&before, &after})
        for (auto match = std::sregex_iterator(line.begin(), line.end(), *pattern); match != std::sregex_iterator(); ++match)
            if (std::stod((*match)[1]) != 0) return true;
    return false;
}

/// A number next to 0 that kernels may have: a bound on rounding errors or a unit, never a guess.
struct SmallNumber {
    const char *file, *number, *derivation;
};

/// All of them, by file, outside kernels/core/math.cl, which has polynomials. A new one comes with the place where it is derived.
const SmallNumber small_numbers[] = {
    {"kernels/accelerators/volumes.cl", "0x1p-60f", "stands for a rate of 0, as in lane_ray.cl"},
    {"kernels/accelerators/rows.cl", "0x1p-11f", "what rounding makes of t times the determinant: ray_doubt's comment"},
    {"kernels/bsdfs/microfacet.cl", "0x1p-126f", "the least normal number instead of 0: the comments beside it"},
    {"kernels/core/lane_ray.cl", "0x1p-20f", "pad: two roundings of the slabs' products and of the shifted origin; within_box's comment"},
    {"kernels/core/lane_ray.cl", "0x1p-60f", "stands for a direction's component of 0: the comment above it"},
    {"kernels/core/random.cl", "0x1p-24f", "the unit of 24 random bits"},
    {"kernels/core/refraction.cl", "0x1p-126f", "the least normal number instead of 0: the comment beside it"},
    {"kernels/core/spawn.cl", "0x1p-126f", "the least normal number instead of 0, for a tip of radius 0 at the origin"},
    {"kernels/core/spawn.cl", "0x1p-22f", "rounding of a spawned ray's origin: bend's comment"},
    {"kernels/core/spawn.cl", "0x1p-21f", "rounding of a shadow ray's two ends: ray_to_light's comment"},
    {"kernels/lights/emission.cl", "0x1p-20f", "rounding of a shadow ray's two ends: emission_sample's comment"},
    {"kernels/lights/emissive_disk.cl", "0x1p-20f", "rounding of the point: emissive_disk_sample's comment"},
    {"kernels/lights/emissive_flat.cl", "0x1p-20f", "rounding of a point of the face: four times emissive_flat_sample's bound"},
    {"kernels/lights/emissive_mesh.cl", "0x1p-16f", "unit: steps of Morton's curve"},
    {"kernels/lights/emissive_instances.cl", "0x1p-21f", "the way of a ray into the group's space: the comment above it"},
    {"kernels/lights/emissive_instances.cl", "0x1p-22f", "the way of a point to the world: the comment above it"},
    {"kernels/lights/emissive_frustum.cl", "0x1p-126f", "the least normal number instead of 0, for a tip of radius 0"},
    {"kernels/lights/emissive_frustum.cl", "0x1p-20f", "error of the point put together from centre, axis and radius: twice that of frustum_surface"},
    {"kernels/lights/emissive_sphere.cl", "0x1p-48f", "the square of half a unit of 1, instead of a horizon whose density is 0"},
    {"kernels/lights/environment.cl", "0x1p-24f", "the unit of 24 random bits"},
    {"kernels/lights/emissive_sphere.cl", "0x1p-21f", "error of the point put onto the sphere: as in sphere_surface before the correction"},
    {"kernels/primitives/instance_space.cl", "0x1p-21f", "rounding on the way to the world and back: surface_in_world's comment"},
    {"kernels/primitives/instance_space.cl", "0x1p-22f", "rounding of the point in the world: the same"},
    {"kernels/primitives/disk.cl", "0x1p-22f", "rounding of the point: the comment above it"},
    {"kernels/primitives/disk.cl", "0x1p-38f", "what the correction leaves: the comment above it"},
    {"kernels/primitives/frustum.cl", "0x1p-21f", "error of the point put back onto the surface: frustum_surface's comment"},
    {"kernels/primitives/frustum_hit.cl", "0x1p-20f", "rounding of the quadratic's constant term: the comment above it"},
    {"kernels/primitives/sphere.cl", "0x1p-22f", "rounding of the point: the comment above it"},
    {"kernels/primitives/sphere.cl", "0x1p-38f", "what the correction leaves: the comment above it"},
    {"kernels/primitives/triangle.cl", "0x1p-22f", "rounding of the point: the comment above it"},
    {"kernels/primitives/triangle.cl", "0x1p-38f", "what the correction leaves: the comment above it"},
    {"kernels/primitives/triangle_crossing.cl", "0x1p-19f", "rounding of the distance from the plane: the comment above it"},
    {"kernels/stages/develop.cl", "0x1p-32f", "the film's unit"},
    {"kernels/stages/weigh_values.cl", "0x1p-30f", "the unit of filters' weights"},
};

/// Numbers between 0 and 2^-10 in a line, wherever they are: compared, in a product that is compared, or in a variable that will be.
std::vector<std::string> small_numbers_in(const std::string &line) {
    static const std::regex number(R"((?:0x[\da-f.]+p[+-]?\d+|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)f?)", std::regex::icase);
    std::vector<std::string> found;
    for (auto match = std::sregex_iterator(line.begin(), line.end(), number); match != std::sregex_iterator(); ++match)
        if (const double value = std::stod(match->str()); value != 0 && value < 0x1p-10) found.push_back(match->str());
    return found;
}

/// Functions of OpenCL's library that are not exact or correctly rounded.
bool has_library_function(const std::string &line) {
    static const std::regex pattern(
        R"(\b(?:native_\w+|half_\w+|fast_\w+|a?sin(?:h|pi)?|a?cos(?:h|pi)?|a?tan(?:h|pi)?|atan2(?:pi)?|sincos|exp(?:2|10|m1)?|log(?:2|10|1p|b)?|)"
        R"(pow[nr]?|rootn|cbrt|hypot|rsqrt|erfc?|[lt]gamma|mad|mix|smoothstep|dot|cross|length|distance|normalize)\s*\()");
    return std::regex_search(line, pattern);
}

bool turns_contraction_on(const std::string &line) {
    static const std::regex pattern(R"(FP_CONTRACT\s+(ON|DEFAULT)|fast-relaxed-math|mad-enable)");
    return std::regex_search(line, pattern);
}

void expect_none(const std::vector<std::string> &offences) {
    for (const std::string &offence : offences) ADD_FAILURE() << offence;
}

TEST(NoEpsilon, NoDistanceAlongARayIsComparedWithANumberBut0) { expect_none(offences(has_epsilon)); }

TEST(NoEpsilon, EverySmallNumberIsABoundThatIsDerivedSomewhere) {
    std::set<std::pair<std::string, std::string>> allowed, found;
    for (const SmallNumber &number : small_numbers) allowed.emplace(number.file, number.number);
    for (const EmbeddedFile &file : embedded_kernels()) {
        if (file.path == "kernels/core/math.cl") continue;
        std::istringstream lines(without_comments(std::string(file.text)));
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number)
            for (const std::string &small : small_numbers_in(line)) {
                found.emplace(file.path, small);
                EXPECT_TRUE(allowed.contains({std::string(file.path), small})) << file.path << ":" << number << ": " << line;
            }
    }
    for (const auto &[file, number] : allowed) EXPECT_TRUE(found.contains({file, number})) << number << " is no longer in " << file;
}

TEST(NoEpsilon, NoLibraryFunctionThatDevicesRoundDifferently) { expect_none(offences(has_library_function)); }

TEST(NoEpsilon, ContractionIsOffInEveryKernelFile) {
    expect_none(offences(turns_contraction_on));
    EXPECT_NE(expand_source("kernels/core/portable.h", {}).find("#pragma OPENCL FP_CONTRACT OFF"), std::string::npos);
    for (const EmbeddedFile &file : embedded_kernels()) {
        if (file.text.find("\nkernel void ") == std::string_view::npos) continue;
        EXPECT_NE(file.text.find("#include \"kernels/"), std::string_view::npos) << file.path << " includes nothing, so not portable.h either";
    }
}

TEST(NoEpsilon, TheSearchFindsEpsilons) {
    for (const std::string line : {"if (t > 0.001f) return;", "hit = crossing.t > 1e-4f;", "t0 >= 0x1p-10f", "ray.t_max<-1.0f", "near > 1.f",
                                   "x & (1e-3f < t)", "0.5f <= hit->t", "t[j] > .01f", "near > (float8)(0.001f)", "const float EPSILON = 1e-3f;",
                                   "t > 0.0001f", "t1 > 0.0f ? a : b; distance < 1e30f"})
        EXPECT_EQ(offences("x.cl", line, has_epsilon).size(), 1u) << line;
}

TEST(NoEpsilon, TheSearchLeavesTheRestAlone) {
    for (const std::string line : {"if (t > 0.0f) return;", "crossing.hit &= t0 > 0.0f & t0 <= ray.t_max;", "t > (float8)(0.0f)", "ray.t_max >= 0.0f",
                                   "t > 0", "high > 129.0f ? a : b", "// t > 0.001f", "cost > 0.5f", "first > 1u", "0.0f < t", "near <= far"})
        EXPECT_EQ(offences("x.cl", line, has_epsilon).size(), 0u) << line;
}

TEST(NoEpsilon, TheSearchFindsSmallNumbersHoweverTheyAreUsed) {
    for (const std::string line :
         {"starts_on = fabs(c) <= 0x1p-21f * ff;", "t > scale * 1e-4f", "const real bound = .0005f * size;", "0.0001f", "3E-5f"})
        EXPECT_EQ(small_numbers_in(line).size(), 1u) << line;
    for (const std::string line : {"t > 0.0f", "0.5f * x", "words[3] + 0u", "0x7feb352du", "0x00000001u", "0x1p17f", "sum3.x * 1e3f", "x2 - 0.00f"})
        EXPECT_EQ(small_numbers_in(line).size(), 0u) << line;
}

TEST(NoEpsilon, TheSearchFindsLibraryFunctions) {
    for (const std::string line :
         {"x = exp(y);", "x = native_sqrt(y);", "pow (a, b)", "length(v)", "a = mad(b, c, d);", "rsqrt(x)", "half_recip(x)", "acos(x)"})
        EXPECT_EQ(offences("x.cl", line, has_library_function).size(), 1u) << line;
    for (const std::string line :
         {"x = exponential(y);", "power(a, b)", "sqrt(x)", "fma(a, b, c)", "float distance = sqrt(x);", "dot3(a, b)", "// exp(x)"})
        EXPECT_EQ(offences("x.cl", line, has_library_function).size(), 0u) << line;
}

}  // namespace
}  // namespace brandung
