/// The native scene format: JSON, as `brandung.schema.json` describes it.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/choosing.h"
#include "scene/cameras/camera.h"
#include "scene/formats/format.h"
#include "scene/lights/light.h"
#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/vectors.h"
#include "scene/view.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

template <class Thing> std::vector<std::string> names_of(const std::vector<Thing> &things) {
    std::vector<std::string> names;
    for (const Thing &thing : things) names.emplace_back(thing.name);
    return names;
}

/// The kind that the value "type" names.
template <class Kind> const Kind &kind_of(const Parameters &parameters, const std::vector<Kind> &kinds) {
    return kinds[parameters.choice("type", names_of(kinds))];
}

/// The value "name", which no other of `things` may have.
template <class Thing> std::string new_name(const Parameters &parameters, const std::vector<Thing> &things) {
    std::string name = parameters.text("name");
    if (name.empty()) parameters.fail("name", "must not be empty");
    if (std::any_of(things.begin(), things.end(), [&](const Thing &thing) { return thing.name == name; }))
        parameters.fail("name", "\"" + name + "\" is the name of an earlier one");
    return name;
}

Material read_material(const Parameters &parameters, Scene &scene) {
    std::vector<std::string> types = names_of(bsdf_kinds());
    for (const ChoosingKind &kind : choosing_kinds()) types.emplace_back(kind.name);
    const std::size_t type = parameters.choice("type", types), bsdfs = bsdf_kinds().size();
    return type < bsdfs ? bsdf_kinds()[type].read(parameters, scene) : read_choosing(parameters, choosing_kinds()[type - bsdfs], scene);
}

void read_materials(const Parameters &root, Scene &scene) {
    for (const Parameters &parameters : root.children("materials")) {
        const std::string name = new_name(parameters, scene.materials);
        scene.materials.push_back({name, read_material(parameters, scene)});
        parameters.expect_all_known();
        place_warnings(scene, [&] { return parameters.place(""); });
    }
}

/// Of materials that choose: any of the scene, also those that files of meshes have brought along.
void read_members(const Parameters &root, Scene &scene) {
    const std::vector<Parameters> choosing = root.children("materials");
    const std::vector<std::string> names = names_of(scene.materials);
    for (std::size_t m = 0; m < choosing.size(); ++m)
        if (chooses(scene.materials[m].record)) name_members(choosing[m], names, scene.materials[m].record);
    for (std::size_t m = 0; m < choosing.size(); ++m) expect_members(choosing[m], scene, uint(m));
}

void read_lights(const Parameters &root, Scene &scene) {
    for (const Parameters &parameters : root.children("lights")) {
        scene.lights.push_back(kind_of(parameters, lights_of_files()).read(parameters));
        parameters.expect_all_known();
    }
}

/// Times of keys, two at least, grow from one to the next.
void expect_growing(const std::vector<Parameters> &keys, const Parameters &parent, const std::string &name) {
    if (keys.size() < 2) parent.fail(name, "needs at least two keys, or none");
    for (std::size_t k = 1; k < keys.size(); ++k)
        if (!(keys[k].number("time") > keys[k - 1].number("time"))) keys[k].fail("time", "must be later than that of the key before");
}

/// Whether the transform is a list of keys, not of steps.
bool has_keys(const Parameters &parameters) {
    const std::vector<Parameters> list = parameters.one_or_more("transform");
    return std::any_of(list.begin(), list.end(), [](const Parameters &element) { return element.has("time"); });
}

std::vector<MotionKey> read_keys(const Parameters &parameters) {
    const std::vector<Parameters> list = parameters.one_or_more("transform");
    expect_growing(list, parameters, "transform");
    std::vector<MotionKey> keys;
    for (const Parameters &key : list) {
        keys.push_back({double(key.number("time")), read_transform(key)});
        key.expect_all_known();
    }
    return keys;
}

void read_instance(const Parameters &parameters, const std::vector<std::string> &materials, Scene &scene) {
    if (scene.groups.empty()) parameters.fail("group", "the scene has no groups");
    const uint group = parameters.choice("group", names_of(scene.groups));
    const uint material = parameters.has("material") ? parameters.choice("material", materials) : NO_MATERIAL;
    const auto fault = has_keys(parameters) ? add_instance(scene, group, Motion(read_keys(parameters)), material)
                                            : add_instance(scene, group, read_transform(parameters), material);
    if (fault) parameters.fail("transform", *fault);
}

/// What an object has added to the scene, beyond so many shapes and instances, gets the object's number.
void number_object(uint object, std::size_t shapes, std::size_t instances, Scene &scene) {
    for (std::size_t i = shapes; i < scene.shapes.size(); ++i) scene.shapes[i]->object = object;
    for (std::size_t i = instances; i < scene.instances.size(); ++i) scene.instances[i].object = object;
}

/// The array "objects" of the scene, or of a group, where there are no instances. `materials` are the scene's own, which come before those of
/// files.
void read_objects(const Parameters &parent, bool with_instances, const std::vector<std::string> &materials, Scene &scene) {
    std::vector<std::string> types = names_of(shape_readers());
    if (with_instances) types.emplace_back("instance");
    uint object = 0;
    for (const Parameters &parameters : parent.children("objects")) {
        const std::size_t shapes = scene.shapes.size(), instances = scene.instances.size();
        const uint type = parameters.choice("type", types);
        const bool is_instance = type == shape_readers().size();
        const bool unnamed = (is_instance || shape_readers()[type].from_file) && !parameters.has("material");
        if (materials.empty() && !unnamed) parameters.fail("material", "the scene has no materials");
        if (is_instance)
            read_instance(parameters, materials, scene);
        else
            shape_readers()[type].read(parameters, unnamed ? material_of_file : parameters.choice("material", materials), scene);
        parameters.expect_all_known();
        number_object(object++, shapes, instances, scene);
        place_warnings(scene, [&] { return parameters.place(""); });
    }
}

/// Readers add objects to the scene, which has none of its own yet.
void read_groups(const Parameters &root, const std::vector<std::string> &materials, Scene &scene) {
    for (const Parameters &parameters : root.children("groups")) {
        const std::string name = new_name(parameters, scene.groups);
        read_objects(parameters, false, materials, scene);
        parameters.expect_all_known();
        add_group(scene, name, std::exchange(scene.shapes, {}));
    }
}

std::string transparent_materials(const Scene &scene) {
    std::string names;
    for (const NamedMaterial &material : scene.materials)
        if (material.record.flags & MATERIAL_TRANSMITS) names += (names.empty() ? "" : ", ") + material.name;
    return names.empty() ? "none is transparent" : "transparent: " + names;
}

/// The materials that the eye is in, also those that files of meshes have brought along.
std::vector<std::string> read_inside(const Parameters &parameters, const Scene &scene) {
    std::vector<std::string> names = parameters.texts("inside");
    for (const std::string &name : names) {
        const auto same_name = [&](const NamedMaterial &material) { return material.name == name; };
        const auto found = std::find_if(scene.materials.begin(), scene.materials.end(), same_name);
        if (found == scene.materials.end()) parameters.fail("inside", "there is no material \"" + name + "\"; " + transparent_materials(scene));
        if (!(found->record.flags & MATERIAL_TRANSMITS))
            parameters.fail("inside", "material \"" + name + "\" is not transparent; " + transparent_materials(scene));
    }
    return names;
}

/// What a key leaves out is as the camera says.
void read_view(const Parameters &parameters, const Parameters &of_camera, CameraDescription &camera) {
    const auto part = [&](const char *name, std::optional<vec3> otherwise) {
        return parameters.vector(name, of_camera.has(name) ? of_camera.vector(name) : otherwise);
    };
    camera.from = part("from", {}), camera.at = part("at", {}), camera.up = part("up", vec3(0, 1, 0));
    if (const auto fault = view_fault(camera)) parameters.fail(fault->key, fault->why);
}

/// The camera stands where it is at the first of its keys.
void read_camera_keys(const Parameters &parameters, CameraDescription &camera) {
    const std::vector<Parameters> keys = parameters.children("keys");
    expect_growing(keys, parameters, "keys");
    for (const Parameters &key : keys) {
        CameraDescription there = camera;
        read_view(key, parameters, there);
        const double time = double(key.number("time"));
        key.expect_all_known();
        camera.keys.push_back({time, there.from, there.at, there.up});
    }
    camera.from = camera.keys[0].from, camera.at = camera.keys[0].at, camera.up = camera.keys[0].up;
    keep_focus_distance(camera);
}

Shutter read_shutter(const Parameters &parameters) {
    if (!parameters.has("shutter")) return {};
    const std::vector<float> times = parameters.numbers("shutter", 2);
    if (times[1] < times[0]) parameters.fail("shutter", "must not close before it opens");
    return {double(times[0]), double(times[1])};
}

CameraDescription read_camera(const Parameters &parameters, const std::string &name, const Scene &scene) {
    CameraDescription camera;
    camera.name = name;
    camera.shutter = read_shutter(parameters);
    read_kind(parameters, camera);
    camera.inside = read_inside(parameters, scene);
    if (parameters.has("keys"))
        read_camera_keys(parameters, camera);
    else
        read_view(parameters, parameters, camera);
    parameters.expect_all_known();
    if (is_at_rest(camera)) return at_rest(camera, camera.shutter.open);
    if (!camera_motion(camera, scene.shutter)) parameters.fail("keys", "the camera changes too much between its keys");
    return camera;
}

/// Of all cameras, which are read when the scene's things have been.
Shutter read_shutters(const Parameters &root) {
    std::vector<Parameters> cameras = root.children("cameras");
    if (root.has("camera")) cameras.push_back(root.child("camera"));
    std::optional<Shutter> all;
    for (const Parameters &camera : cameras) {
        const Shutter shutter = read_shutter(camera);
        all = {all ? std::min(all->open, shutter.open) : shutter.open, all ? std::max(all->close, shutter.close) : shutter.close};
    }
    return all.value_or(Shutter{});
}

void read_cameras(const Parameters &root, Scene &scene) {
    if (root.has("camera") && root.has("cameras")) root.fail("cameras", "the scene has both \"camera\" and \"cameras\", but needs only one of them");
    if (!root.has("camera") && !root.has("cameras")) root.fail("", "needs either \"camera\" or \"cameras\"");
    if (root.has("camera")) {
        const Parameters parameters = root.child("camera");
        scene.cameras.push_back(read_camera(parameters, parameters.text("name", "camera"), scene));
    }
    for (const Parameters &parameters : root.children("cameras"))
        scene.cameras.push_back(read_camera(parameters, new_name(parameters, scene.cameras), scene));
    if (scene.cameras.empty()) root.fail("cameras", "must not be empty");
}

void read_ambient(const Parameters &root, Scene &scene) {
    scene.ambient = root.spectrum("ambient", scene.ambient);
    if (!scene.integrator.traces_paths() || largest(scene.ambient) == 0) return;
    ++scene.warnings["ambient has no effect with " + scene.integrator.type];
    place_warnings(scene, [&] { return root.place("ambient"); });
}

/// Refuses unknown keys before a missing one is noticed, which is often the same one misspelt.
void check_keys(const Parameters &root) {
    for (const char *key : {"$schema", "description"}) root.text(key, "");
    for (const char *key : {"film", "integrator", "accelerator", "accelerator_quality", "background", "ambient", "camera", "cameras", "materials",
                            "lights", "groups", "objects"})
        root.has(key);
    root.expect_all_known();
}

}  // namespace

Scene read_native(const std::string &file, const ReadOptions &options) {
    Document document = read_document(file);
    document.progress = options.progress;
    Parameters(document, "");  // what is no object is refused as such, not as one without the members to set
    for (const std::string &assignment : options.assignments) set_value(document, assignment);
    const Parameters root(document, "");
    check_keys(root);

    Scene scene;
    if (options.keep_places) scene.places.emplace();
    scene.file = file;
    scene.integrator.shadows_unsaid = true;
    read_settings(root, scene);
    read_ambient(root, scene);
    read_materials(root, scene);
    read_lights(root, scene);
    const std::vector<std::string> materials = names_of(scene.materials);
    scene.shutter = read_shutters(root);
    read_groups(root, materials, scene);
    read_objects(root, true, materials, scene);
    read_members(root, scene);
    read_cameras(root, scene);
    return scene;
}

}  // namespace brandung
