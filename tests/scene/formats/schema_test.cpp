#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "scene/accelerators/accelerator.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/choosing.h"
#include "scene/cameras/camera.h"
#include "scene/lights/light.h"
#include "tests/scene/formats/temporary_file.h"

namespace brandung {
namespace {

class Schema : public testing::Test {
protected:
    nlohmann::json schema = nlohmann::json::parse(std::ifstream(BRANDUNG_SOURCE_DIR "/scene/formats/brandung.schema.json"));

    /// The values of "type" that the alternatives of a definition name.
    std::vector<std::string> types_of(const std::string &family) const {
        std::vector<std::string> result;
        for (const nlohmann::json &alternative : schema.at("definitions").at(family).at("oneOf")) {
            const std::string name = alternative.at("$ref").get<std::string>().substr(std::strlen("#/definitions/"));
            result.push_back(schema.at("definitions").at(name).at("properties").at("type").at("const"));
        }
        return result;
    }
    nlohmann::json defaults_of(const std::string &definition) const {
        nlohmann::json result = nlohmann::json::object();
        for (const auto &[key, property] : schema.at("definitions").at(definition).at("properties").items())
            if (property.contains("default")) result[key] = property["default"];
        if (result.contains("penumbra") || definition == "point") result["attenuation"] = schema.at("definitions").at("attenuation").at("default");
        return result;
    }
};

template <class Kind> std::vector<std::string> names_of(const std::vector<Kind> &kinds) {
    std::vector<std::string> result;
    for (const Kind &kind : kinds) result.emplace_back(kind.name);
    return result;
}

/// Records consist of 4-byte scalars, without gaps.
template <class Record> std::vector<std::byte> bytes_of(const Record &record) {
    const auto bytes = std::as_bytes(std::span(&record, 1));
    return {bytes.begin(), bytes.end()};
}

TEST_F(Schema, NamesTheKindsThatTheReaderKnows) {
    EXPECT_EQ(types_of("shape"), names_of(shape_readers()));
    std::vector<std::string> materials = names_of(bsdf_kinds());
    for (const std::string &kind : names_of(choosing_kinds())) materials.push_back(kind);
    EXPECT_EQ(types_of("material"), materials);
    EXPECT_EQ(types_of("light"), names_of(lights_of_files()));
    EXPECT_EQ(types_of("camera"), names_of(camera_kinds()));
    std::vector<std::string> accelerators = names_of(accelerator_kinds());
    accelerators.insert(accelerators.begin(), "auto");
    EXPECT_EQ(schema.at("properties").at("accelerator").at("enum").get<std::vector<std::string>>(), accelerators);
    EXPECT_EQ(schema.at("properties").at("accelerator_quality").at("enum").get<std::vector<std::string>>(),
              std::vector<std::string>(build_quality_names.begin(), build_quality_names.end()));
}

TEST_F(Schema, ItsDefaultsAreTheReaders) {
    nlohmann::json bare = {{"camera", {{"from", {0, 0, 5}}, {"at", {0, 0, 0}}}},
                           {"materials", {{{"name", "m"}, {"type", "whitted"}}}},
                           {"lights",
                            {{{"type", "point"}, {"position", {0, 0, 0}}, {"intensity", 1}},
                             {{"type", "spot"}, {"position", {0, 0, 0}}, {"intensity", 1}, {"at", {0, 0, 1}}}}}};
    nlohmann::json full = bare;
    full["film"] = defaults_of("film"), full["integrator"] = defaults_of("integrator");
    full["integrator"]["bundles"] = defaults_of("bundles");
    full["camera"].update(defaults_of("perspective_camera")), full["materials"][0].update(defaults_of("whitted")),
        full["lights"][0].update(defaults_of("point")), full["lights"][1].update(defaults_of("spot"));
    const Scene a = read_text(bare.dump()), b = read_text(full.dump());
    EXPECT_TRUE(a.film == b.film);
    EXPECT_EQ(a.integrator.type, b.integrator.type);
    EXPECT_EQ(a.integrator.max_depth, b.integrator.max_depth);
    EXPECT_EQ(a.integrator.threshold, b.integrator.threshold);
    EXPECT_EQ(a.integrator.light_samples, b.integrator.light_samples);
    EXPECT_EQ(bytes_of(a.integrator.bundles), bytes_of(b.integrator.bundles));
    EXPECT_EQ(a.integrator.filtered_shadows, b.integrator.filtered_shadows);
    EXPECT_EQ(a.cameras[0].up, b.cameras[0].up);
    EXPECT_EQ(a.cameras[0].fov, b.cameras[0].fov);
    EXPECT_EQ(bytes_of(a.materials[0].record), bytes_of(b.materials[0].record));
    for (const std::size_t i : {0, 1}) EXPECT_EQ(bytes_of(a.lights[i]), bytes_of(b.lights[i]));
}

TEST_F(Schema, ItsDefaultsAreThoseOfEveryCamera) {
    for (const CameraKind &kind : camera_kinds()) {
        const std::string name = kind.name;
        nlohmann::json camera = {{"type", name}, {"from", {0, 0, 5}}, {"at", {0, 0, 0}}};
        if (name == "orthographic") camera["height"] = 2;
        if (name == "thin_lens") camera["lens_radius"] = 0.1, camera["focus_distance"] = 3;
        nlohmann::json full = camera;
        full.update(defaults_of(name + "_camera"));
        const Camera a = make_camera(read_text(nlohmann::json{{"camera", camera}}.dump()).cameras[0], 3, 2),
                     b = make_camera(read_text(nlohmann::json{{"camera", full}}.dump()).cameras[0], 3, 2);
        EXPECT_EQ(bytes_of(a), bytes_of(b)) << name;
    }
}

}  // namespace
}  // namespace brandung
