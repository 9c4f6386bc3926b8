/// Climb: the rungs of a ladder rendered by every climber, and the reference that is rendered for them.
#pragma once
#include "tools/converge/ladder.h"
#include "tools/converge/reference.h"
#include "tools/progress.h"

namespace brandung {

/// Before anything was measured.
struct Interrupted {};

/// Says what is rendered, and ends a render where the program is interrupted.
class Teller {
public:
    explicit Teller(bool quiet) : quiet_(quiet), line_(quiet) {}
    std::function<bool(const RenderProgress &)> observer(const std::string &what);
    /// A line that stays.
    void note(const std::string &text);
    /// The same, even if all else is quiet.
    void warn(const std::string &text);

private:
    bool quiet_;
    ProgressLine line_;
};

struct Plan {
    Rungs rungs;
    uint repetitions;
    uint first_seed;  ///< of a ladder, whose pictures all have their own; each way has the same ones, so that what they differ by is no chance
};

/// So many samples of the climber's picture. Throws Interrupted.
ReferencePicture render_reference(Climber &climber, uint spp, Teller &teller);
/// Renders a little, so that what drivers still compile then is not timed. Throws Interrupted.
void warm_up(Climber &climber, Teller &teller);
/// One for each climber, without a run yet.
std::vector<Series> series_of(const std::vector<std::unique_ptr<Climber>> &climbers);
/// Rungs one after another, and on each every way with every seed, so that all share what else the machine does; until the program is interrupted.
std::vector<Series> climb(const Plan &plan, const std::vector<std::unique_ptr<Climber>> &climbers, const ReferencePicture &reference, Teller &teller);

}  // namespace brandung
