// Where the program is built without Embree.
#include "runtime/opencl/error.h"
#include "tools/bench/embree_peer.h"

namespace brandung {

struct EmbreePeer::Implementation {};

bool EmbreePeer::is_built_in() { return false; }
EmbreePeer::EmbreePeer(const SceneGeometry &, uint) {
    throw Error("this program was built without Embree: install libembree-dev and build it again");
}
EmbreePeer::~EmbreePeer() = default;
std::string EmbreePeer::version() const { return ""; }
uint EmbreePeer::native_width() const { return 0; }
const std::vector<PeerScene> &EmbreePeer::scenes() const {
    static const std::vector<PeerScene> none;
    return none;
}
void EmbreePeer::take(const RayQueue &) {}
double EmbreePeer::trace(std::size_t, const PeerApi &) { return 0; }
RayAnswers EmbreePeer::answers() const { return {}; }

}  // namespace brandung
