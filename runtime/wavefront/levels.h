/// Levels: rays in flight and their state, one level per generation, in bounded memory whatever the branching.
#pragma once
#include <deque>
#include <optional>

#include "kernels/core/items.h"
#include "runtime/opencl/buffer.h"
#include "runtime/wavefront/wave_step.h"

namespace brandung {

/// What only some scenes and integrators keep of every ray.
struct SideArrays {
    uint interior_size = 0;  ///< entries of its list of media
    uint place_words = 0;    ///< of what is known of where the primitive is that it leaves
    bool pdfs = false;
};

/// Slots of one generation, filled front to back, and the list of those that are live and not yet handed out.
struct Level {
    Level(Device &device, uint capacity, SideArrays sides)
        : rays(device, capacity),
          sources(device, std::size_t{capacity} * sides.place_words),
          paths(device, capacity),
          pdfs(device, sides.pdfs ? capacity : 0),
          interiors(device, std::size_t{capacity} * sides.interior_size),
          live(device, capacity) {}
    Buffer<Ray> rays;
    Buffer<uint> sources;  ///< instances of the primitives that the rays leave, in scenes with instances, and the rays' times where some move
    Buffer<Path> paths;
    Buffer<float> pdfs;      ///< densities by which their directions were chosen [1/sr], for integrators that weigh them
    Buffer<uint> interiors;  ///< interior_size entries per slot
    Buffer<uint> live;
    uint used = 0;            ///< slots taken
    uint first = 0, end = 0;  ///< of `live`: what is waiting
    std::size_t bytes() const { return rays.bytes() + sources.bytes() + paths.bytes() + pdfs.bytes() + interiors.bytes() + live.bytes(); }
};

/// A part of a level to work on, and where its children go: to slots base + j * count + i of the next level, for child j of item i.
/// As kernel argument it is LIVE_PARAMS: list, first, count.
struct Wave {
    Level &level;
    uint first, count;
    uint generation;
    Level *children;  ///< null without branching
    uint base;

    template <class Bind> void for_each_argument(Bind bind) const { bind(level.live), bind(first), bind(count); }
};

/// Children per item: of the first generation, and of all others.
struct Branching {
    uint first, others;
};

/// Hands out waves so that no level ever overflows: a wave takes at most as many items as the next level has free slots for their children.
class Levels {
public:
    /// Levels are allocated when first needed, at most `generations` of them, each of max(batch, branching) slots. Waves have at most `batch`
    /// items. `sides` says which side arrays they have. `on_step` is told each step, if there is one.
    Levels(Device &device, uint batch, Branching branching, uint generations, SideArrays sides, WatchSteps on_step = {});

    /// Forgets everything, and allocates the first level if there is none yet, as `next` does; the caller fills the first `count` slots of the result
    /// and its live list.
    Level &start(uint count);
    /// From the deepest level that has a full launch, else from the shallowest that has any; nothing when all rays have ended. Allocates the level
    /// of the children if it is the first time that one is needed; throws Error if the device cannot hold it.
    std::optional<Wave> next();
    /// Tells how many of the last wave's children live; their list was written from the next level's `end` on.
    void add_children(const Wave &wave, uint live);

    /// Slots of a level.
    uint capacity() const { return capacity_; }
    /// Items of a wave of that generation, at most.
    uint wave_size(uint generation) const;
    std::size_t bytes_at_most() const { return generations_ * level_bytes_; }

private:
    Level &level(uint generation);
    uint branching(uint generation) const { return generation == 0 ? branching_.first : branching_.others; }
    uint room(uint generation);
    uint choose();
    void tell_step(uint generation, uint count) const;

    Device &device_;
    uint batch_;
    Branching branching_;
    uint capacity_, generations_, full_launch_;
    SideArrays sides_;
    std::size_t level_bytes_;
    WatchSteps on_step_;
    std::deque<Level> levels_;
};

}  // namespace brandung
