// Where the program is built without Embree.
#include "runtime/opencl/error.h"
#include "tools/bench/embree_peer.h"

namespace brandung {

struct EmbreePeer::Implementation {};

void EmbreePeer::check_built_in() { throw Error("this program was built without Embree: install libembree-dev and build it again"); }
std::string EmbreePeer::refusal(const SceneGeometry &) { return ""; }
EmbreePeer::EmbreePeer(const SceneGeometry &, uint) { check_built_in(); }
EmbreePeer::~EmbreePeer() = default;
std::string EmbreePeer::version() const { return ""; }
uint EmbreePeer::native_width() const { return 0; }
std::string EmbreePeer::instructions() const { return ""; }
void EmbreePeer::build_again() {}
const std::vector<PeerScene> &EmbreePeer::scenes() const {
    static const std::vector<PeerScene> none;
    return none;
}
void EmbreePeer::take(const RaySpan &) {}
bool EmbreePeer::can_trace(const PeerApi &, bool) const { return false; }
double EmbreePeer::trace(std::size_t, const PeerApi &) { return 0; }
RayAnswers EmbreePeer::answers() const { return {}; }

}  // namespace brandung
