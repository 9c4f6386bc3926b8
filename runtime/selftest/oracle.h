/// PrimitiveOracle: the host's side of one kind of primitive in the self-test: inputs that are hard for it, and what is right there, in extended
/// precision and by formulas that the kernels do not use.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "kernels/core/items.h"
#include "kernels/primitives/smooth_triangle.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/roots.h"
#include "scene/primitives/shape.h"

namespace brandung {

/// One primitive as the kernels see it, rounded: a lane of a block.
struct Lane {
    const std::byte *block;
    uint lane;
    template <class Block> const Block &as() const { return *reinterpret_cast<const Block *>(block); }
};

/// A point that rays are aimed at, on the surface or at its edges, and the surface's normal there, to rounding.
struct Aim {
    vec3 point, normal;
};

/// The true unit normal, and how far from it rounding may take the kernel's.
struct Normal {
    Vector n;
    extended error;
};

/// True coordinates on the surface, and how far from them rounding may take the kernel's. An error of 1/2 or more says that nothing is known.
struct Place {
    std::array<extended, 2> uv;
    std::array<extended, 2> error;
};

/// One over a density by area, and the relative error of it.
struct Density {
    extended inverse, error;
};

class PrimitiveOracle {
public:
    virtual ~PrimitiveOracle() = default;
    virtual const PrimitiveKind &kind() const = 0;

    /// One primitive about so large, at a place; thin, flat, or inside out at times. Null if it would have no surface.
    virtual std::unique_ptr<Shape> make(InputSource &source, vec3 place, float size) const = 0;
    virtual Aim aim(InputSource &source, Lane lane) const = 0;

    /// All crossings with the ray's line that the surface shows to it.
    virtual std::vector<Root> roots(Lane lane, const Ray &ray) const = 0;
    /// From the surface, extended without its ends, to p; positive on the side to which normals point.
    virtual extended distance(Lane lane, Vector p) const = 0;
    /// Where the ray has t, in the kernel's opinion. An error of 1 or more says that nothing is known.
    virtual Normal normal_on(Lane lane, const Ray &ray, extended t) const = 0;
    /// Coordinates there: of kinds with vertices the weights of the second and third one, of others those of pictures, of which the first goes
    /// around.
    virtual Place place_on(Lane lane, const Ray &ray, extended t) const = 0;
    /// The shading normal there, of either sign, of kinds whose vertices have normals; the others' is the normal.
    virtual Normal shading_normal_on(Lane lane, const VertexNormals &, const Ray &ray, extended t) const { return normal_on(lane, ray, t); }
    /// At a point that a kernel has put onto the surface.
    virtual Normal normal_at(Lane lane, Vector p) const = 0;
    /// How far beyond the surface's ends p is at most, along it.
    virtual extended beyond_ends(Lane lane, Vector p) const = 0;
    /// As a light: one over the density, by area, with which p of its surface is chosen where `from` is lit, and how far rounding takes it from that
    /// if p and `from` are known to within `slack` and `from_slack`.
    virtual Density inverse_density(Lane lane, Vector p, Vector from, extended slack, extended from_slack) const = 0;
    /// How far it is from such a point to where the inside ends, or another part of the surface is, at least.
    virtual extended room(Lane lane, Vector p) const = 0;
};

/// One per kind in primitive_kinds(), in its order. Throws std::out_of_range, with the name, if a kind has none.
const std::vector<const PrimitiveOracle *> &primitive_oracles();

}  // namespace brandung
