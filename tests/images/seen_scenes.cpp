#include "tests/images/seen_scenes.h"

#include <cmath>

namespace brandung {

Scene scene_seen_from(vec3 from, vec3 at, float degrees, uint size) {
    Scene scene;
    scene.file = "seen";
    CameraDescription camera;
    camera.from = from, camera.at = at, camera.fov = glm::radians(degrees);
    camera.up = std::abs(glm::normalize(at - from).y) > 0.9f ? vec3(0, 0, -1) : vec3(0, 1, 0);
    scene.cameras.push_back(camera);
    scene.film.width = scene.film.height = size;
    return scene;
}

void add_quad(Scene &scene, uint material, vec3 a, vec3 b, vec3 c, vec3 d) {
    MeshData mesh;
    append_polygon(scene, mesh, {a, b, c, d}, {});
    add_triangle_mesh(scene, material, std::move(mesh));
}

void add_floor(Scene &scene, uint material, float half, float height) {
    add_quad(scene, material, {-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half});
}

void add_box(Scene &scene, uint material, vec3 low, vec3 high, bool inwards) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const auto corner = [&](bool u, bool v) {
                vec3 p;
                p[axis] = upper ? high[axis] : low[axis];
                const bool swap = upper == inwards;
                p[(axis + 1) % 3] = (swap ? v : u) ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
                p[(axis + 2) % 3] = (swap ? u : v) ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
                return p;
            };
            add_quad(scene, material, corner(false, false), corner(true, false), corner(true, true), corner(false, true));
        }
}

}  // namespace brandung
