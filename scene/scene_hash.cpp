#include "scene/scene_hash.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>

#include "kernels/primitives/instance.h"
#include "scene/cameras/camera.h"
#include "scene/compilation/spaces.h"

namespace brandung {
namespace {

/// Takes 8 bytes at a time; mixes as MurmurHash3 (A. Appleby) does. The order counts.
class Hash {
public:
    void add(std::span<const std::byte> bytes) {
        for (std::size_t done = 0; done < bytes.size(); done += sizeof(std::uint64_t)) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + done, std::min(sizeof word, bytes.size() - done));
            add_word(word);
        }
        add_word(bytes.size());  // the same bytes cut differently are something else
    }
    template <class T> void add_value(const T &value) { add(std::as_bytes(std::span(&value, 1))); }

    std::uint64_t value() const {
        std::uint64_t mixed = (state_ ^ state_ >> 33) * 0xff51afd7ed558ccdu;
        mixed = (mixed ^ mixed >> 33) * 0xc4ceb9fe1a85ec53u;
        return mixed ^ mixed >> 33;
    }

private:
    void add_word(std::uint64_t word) { state_ = (std::rotl(state_ ^ word * 0x87c37b91114253d5u, 27) + 0x52dce729u) * 0x4cf5ad432745937fu; }

    std::uint64_t state_ = 0;
};

/// Geometry as blocks have it, but in the order of the scene, since accelerators choose what shares a block.
void add_lanes(const Shape &shape, Hash &hash) {
    std::vector<std::byte> block(shape.kind().block_bytes);
    for (std::size_t first = 0; first < shape.count(); first += BLOCK_SIZE) {
        const std::size_t count = std::min<std::size_t>(BLOCK_SIZE, shape.count() - first);
        if (count < BLOCK_SIZE) std::fill(block.begin(), block.end(), std::byte{0});
        for (uint lane = 0; lane < count; ++lane) shape.write_lane(first + lane, lane, block.data());
        hash.add(block);
    }
}

void add_camera(const Scene &scene, const CameraDescription &camera, Hash &hash) {
    for (const vec3 &v : {camera.from, camera.at, camera.up}) hash.add_value(v);
    hash.add_value(camera.fov);
    if (camera.kind != 0) hash.add_value(camera.kind), hash.add_value(make_camera(camera, 1, 1));
    const auto is_inside = [&](const std::string &name) {
        return std::find(camera.inside.begin(), camera.inside.end(), name) != camera.inside.end();
    };
    for (const NamedMaterial &material : scene.materials) hash.add_value(is_inside(material.name));
}

bool moves(const Scene &scene) {
    return std::ranges::any_of(scene.instances, [](const PlacedGroup &placed) { return !placed.motion.empty(); }) ||
           std::ranges::any_of(scene.cameras, [](const CameraDescription &camera) { return !camera.keys.empty(); });
}

void add_motion(const Scene &scene, Hash &hash) {
    hash.add_value(scene.shutter);
    for (const PlacedGroup &placed : scene.instances) hash.add(std::as_bytes(std::span(placed.motion)));
    for (const CameraDescription &camera : scene.cameras) {
        hash.add_value(camera.shutter);
        for (const CameraKey &key : camera.keys) {
            hash.add_value(key.time);
            for (const vec3 &v : {key.from, key.at, key.up}) hash.add_value(v);
        }
    }
}

}  // namespace

std::uint64_t scene_hash(const Scene &scene, const CompiledScene &compiled) {
    const SceneHeader &header = compiled.header;
    const auto records = [&](Span span, std::size_t bytes) {
        return std::span(compiled.arena).subspan(std::size_t{64} * span.offset, span.count * bytes);
    };
    Hash hash;
    hash.add(records(header.shading, sizeof(ShadingRecord)));
    hash.add(records(header.vertex_normals, sizeof(VertexNormals)));
    hash.add(records(header.vertex_uvs, sizeof(VertexUvs)));
    hash.add(records(header.vertex_colors, sizeof(VertexColors)));
    hash.add(records(header.textures, sizeof(TextureRecord)));
    hash.add(std::as_bytes(std::span(compiled.texels)));
    hash.add(records(header.materials, sizeof(Material)));
    hash.add(std::as_bytes(std::span(scene.lights)));  // strata of emissive shapes are the integrator's choice
    for (const auto &shape : scene.shapes) add_lanes(*shape, hash);
    if (!scene.instances.empty()) {
        hash.add(records(header.instances, sizeof(Instance)));
        for (const std::size_t group : groups_in_use(scene))
            for (const auto &shape : scene.groups[group].shapes) add_lanes(*shape, hash);
    }
    hash.add_value(header.background);
    hash.add_value(header.background_texture);
    hash.add_value(header.background_turn);
    hash.add_value(header.ambient);
    for (const CameraDescription &camera : scene.cameras) add_camera(scene, camera, hash);
    if (moves(scene)) add_motion(scene, hash);
    return hash.value();
}

}  // namespace brandung
