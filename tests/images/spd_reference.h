/// A second ray tracer for NFF scenes that only counts rays: double precision, on the host; it shares no code with the first.
/// Opaque surfaces have two sides. T > 0 spawns a reflected ray, whatever its weight, and a refracted one unless reflection is total. A shadow ray
/// goes where N·L > 0: N is the interpolated normal of patches, on the side of the geometric one that the viewer is on; of transparent surfaces the
/// outward one, also from inside, and such a ray begins outside. Transparent objects cast opaque shadows. Spawned rays begin off the surface, on the
/// side that they go to.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>

namespace spd {

struct Counts {
    std::uint64_t primary = 0, primary_hits = 0;
    std::uint64_t shadow = 0, shadow_hits = 0;
    std::uint64_t reflected = 0, reflected_hits = 0;
    std::uint64_t refracted = 0, refracted_hits = 0;

    std::uint64_t secondary() const { return reflected + refracted; }
    std::uint64_t secondary_hits() const { return reflected_hits + refracted_hits; }
    Counts &operator+=(const Counts &other);
};

/// Which normal a light must be in front of: a polygonal patch's interpolated one, on some side of the surface.
enum class LitSide {
    outside_if_transparent,  ///< the outer side of transparent surfaces, the viewer's of opaque ones
    as_given,                ///< the file's, unchanged
    viewer,                  ///< the viewer's
};

/// What the databases' readme leaves open. The defaults are those of the product.
struct Conventions {
    LitSide lit = LitSide::outside_if_transparent;
    bool one_sided_cones = false;              ///< cones and cylinders are not there from behind
    bool cone_normals_of_ratio = false;        ///< a cone's normal leans by 1 - (apex radius)/(base radius) per unit: its height is left out
    bool total_reflection_refracts = false;    ///< then, too, counts a refracted ray, which hits nothing
    bool shading_normals_lead_inside = false;  ///< rays that interpolated normals mirror or refract to the wrong side go there; else they are folded
    double start = 0;                          ///< crossings nearer than this along spawned rays do not count
    bool polygons_shade_from_zero = false;     ///< but with polygons other than patches they do for shadow rays
};

/// Half-open ranges of columns and rows.
struct Block {
    unsigned x0, y0, x1, y1;
};

class Reference {
public:
    /// Reads the file. Throws std::runtime_error.
    explicit Reference(const std::string &file);
    ~Reference();

    /// Of a picture of width x height with one ray through each corner, the part in `block`.
    Counts count(unsigned width, unsigned height, Block block, const Conventions &conventions = {}) const;
    /// The whole picture, by all threads.
    Counts count(unsigned width, unsigned height, const Conventions &conventions = {}) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace spd
