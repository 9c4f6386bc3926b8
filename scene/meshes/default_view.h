/// What a scene gets whose file has nothing but meshes: a camera, and a light.
#pragma once
#include <vector>

#include "scene/meshes/mesh_file.h"
#include "scene/view.h"

namespace brandung {

/// A camera that sees the whole sphere around the meshes' box, from the front, 30 degrees from the right and 20 from above: a box shows three of
/// its sides from there, the front the widest, and no edge hides another. Front is +z, or -y if up is along z. An open shell, whose outward sides
/// do not cancel out and which surrounds its middle but for the opening (a room without its front wall, a mask), is looked into instead, as its
/// sides face, and fills the picture. Where floats have no place for it beside the meshes, it has no direction of view.
/// `changes` are taken into account: the distance follows the angle of view.
struct Framing {
    CameraDescription camera;
    bool in_shell;  ///< whether it looks into one
};
Framing frame(const std::vector<MeshPart> &parts, const FilmSettings &film, const ViewChanges &changes);

/// A light beside the camera, up to the left, so that shapes show; at the camera where that looks into a shell, so that nothing is in the shadow.
/// It has the irradiance pi at every distance: a surface that faces it has its diffuse reflectance as radiance, whatever the scale.
Light headlight(const Framing &framing);

/// Settings that suit most meshes, from which those of the command line differ: samples per pixel, and the root of the number of points of each lamp.
inline constexpr uint mesh_spp = 16, mesh_light_samples = 2;
void set_default_quality(Scene &scene);

/// Adds the camera; the headlight too, unless `parts`, the scene's meshes, light themselves: their emission must be sampled, and give a hundredth
/// of the headlight's irradiance at the distance of their bounding sphere's radius; and ambient light, a tenth of the irradiance. The scene's notes
/// say so as options and as a scene file.
void add_default_view(const std::vector<MeshPart> &parts, const ViewChanges &changes, Scene &scene);

}  // namespace brandung
