/// Traversals compared with one another, and with Embree, on the same rays.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/bench/embree_peer.h"
#include "tools/bench/traversal_rays.h"

namespace brandung {

/// What one traversal of ours does for a set of rays.
struct TraversalRow {
    std::string rays, variant, kernel;
    std::uint64_t kernel_hash = 0;  ///< of its text, for this scene
    std::size_t count = 0;          ///< rays
    bool of_render = false;         ///< a render takes this one for such rays
    std::vector<double> seconds, device_seconds;
    std::uint64_t different = 0;   ///< answers that are not those of the first traversal
    std::uint64_t mismatches = 0;  ///< with Embree's robust scene
};

/// And of Embree.
struct PeerRow {
    std::string rays, scene, api;
    bool robust;
    std::size_t count = 0;
    std::vector<double> seconds;
};

struct TraversalResult {
    std::string scene, accelerator;
    std::size_t primitives = 0, instances = 0, node_bytes = 0, block_bytes = 0;
    double build_seconds = 0;
    std::string peer_version;
    uint peer_width = 0;
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
    std::function<void(const std::string &what)> tell;
    std::function<bool()> goes_on;
};

TraversalResult try_traversals(Device &device, const Scene &scene, const TraversalTrial &trial);

}  // namespace brandung
