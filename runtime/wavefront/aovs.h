/// Aovs: what is recorded of each sample's first hit beside its radiance, as exact sums in fixed point.
#pragma once
#include <limits>
#include <list>
#include <optional>

#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/bands.h"
#include "runtime/wavefront/batch.h"
#include "runtime/wavefront/device_scene.h"
#include "runtime/wavefront/film.h"
#include "runtime/wavefront/filter.h"
#include "runtime/wavefront/levels.h"
#include "scene/aovs/aov.h"
#include "scene/cameras/camera.h"
#include "scene/image.h"
#include "scene/scene.h"

namespace brandung {

class Aovs {
public:
    /// Those that the scene's film asks for, empty. `batch`: rays per wave. Throws Error if the device's memory is too small, and BuildError.
    Aovs(Device &device, const Scene &scene, const CompiledScene &compiled, const DeviceScene &on_device, const CameraDescription &camera, uint batch,
         std::size_t largest_band = std::numeric_limits<std::size_t>::max());

    /// Forgets all samples; those that follow are of rays from this camera.
    void begin(const CameraDescription &camera);
    /// Forgets what waves have recorded: samples without a camera ray are black, and end nowhere.
    void clear_values();
    /// Takes note of a wave of camera rays.
    void record(const Batch &batch, const DeviceScene &scene, const Wave &wave, const Buffer<Hit> &hits, const Buffer<uint> &instances,
                const Buffer<SurfacePoint> &points, const Buffer<Tints> &tints);
    /// Adds what the waves of a batch have recorded.
    void add(const Batch &batch, Filter &filter);
    /// In the order of aov_kinds(), channel by channel; counts of samples are the film's.
    std::vector<PictureChannel> develop(const Film &film) const;

    std::size_t bytes() const;

private:
    /// A mean over samples.
    struct Mean {
        const AovKind &kind;
        float scale;  ///< a value of 1 in fixed point
        Kernel record;
        Buffer<vec3> values;  ///< by slot
        Bands<AovPixel> sums;
    };
    /// Values are recorded in the order of the list of rays, which is not that of their slots where a camera does not see everywhere, or hits are
    /// grouped by their kind of BSDF.
    struct Spreading {
        Kernel spread;
        Buffer<vec3> listed;
    };
    /// A number of the first sample's hit.
    struct Number {
        const AovKind &kind;
        Kernel record;
        Bands<uint> numbers;  ///< from 1 on; 0 for none
    };
    /// Of values that are filtered.
    void add_splats(const Batch &batch, const Splats &splats, float scale, const Access &values, Band<AovPixel> &band);

    std::list<Mean> means_;
    std::optional<Spreading> spreading_;
    PictureSize size_;
    float extent_;                            ///< of the world
    std::optional<Kernel> add_, add_splats_;  ///< for means
    std::list<Number> numbers_;
    std::vector<const AovKind *> of_film_;  ///< those that follow from the film's sums
};

}  // namespace brandung
