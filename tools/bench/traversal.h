/// Traversals compared with one another, and with Embree, on the same rays.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/bench/disagreement.h"
#include "tools/bench/embree_peer.h"
#include "tools/bench/traversal_rays.h"

namespace brandung {

/// What one traversal of ours does for a set of rays.
struct TraversalRow {
    std::string rays;  ///< name of the set
    const Traversal *traversal;
    bool of_render;                                    ///< a render takes this one for such rays
    std::size_t count;                                 ///< rays
    std::string kernel;                                ///< that traces them
    std::uint64_t hash;                                ///< of its text for this scene, with all that it includes
    std::uint64_t different = 0;                       ///< answers that are not, to the bit, those of the first traversal
    std::optional<Disagreement> disagreement;          ///< with Embree's robust scene
    std::vector<double> wall_seconds, device_seconds;  ///< by round
};

/// And one function of Embree.
struct PeerRow {
    std::string rays;
    std::size_t scene;  ///< of EmbreePeer::scenes()
    PeerApi api;
    std::size_t count;
    std::vector<double> seconds;  ///< by round; of one only where that took more than twice the time of the scene's fastest
};

struct TraversalResult {
    std::string scene, accelerator;
    std::size_t primitives = 0, instances = 0, node_bytes = 0, block_bytes = 0;
    std::vector<double> build_seconds;  ///< of each time that it was built
    std::string peer_refusal;           ///< why Embree was left out, if it was
    std::string peer_version;           ///< empty without Embree
    uint peer_width = 0;                ///< EmbreePeer::native_width()
    std::string peer_instructions;      ///< EmbreePeer::instructions()
    std::vector<PeerScene> peer_scenes;
    std::vector<TraversalRow> rows;
    std::vector<PeerRow> peers;
};

struct TraversalTrial {
    std::vector<std::string> rays;
    std::string accelerator;  ///< a name
    std::string camera;       ///< a name, or empty
    bool embree = false;
    uint runs = 5, batch = 262144;
    uint builds = 1;  ///< times that everything is built, in turns
    std::function<void(const std::string &what)> tell;
    std::function<bool()> goes_on;  ///< false ends it: rows have what was measured until then
};

TraversalResult try_traversals(Device &device, const Scene &scene, const TraversalTrial &trial);

}  // namespace brandung
