/// A binary hierarchy by median cut, and for each of its nodes the volume that costs a ray the least.
#include "kernels/accelerators/bounding_volumes.h"

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <numeric>

#include "scene/accelerators/accelerator.h"
#include "scene/accelerators/volume_fit.h"
#include "scene/error.h"

namespace brandung {
namespace {

/// What tests cost a ray [ns of one core], as `brandung bench volumes` gave them on a CPU with AVX-512: only their ratios matter.
constexpr double box_cost = 9;
constexpr double volume_costs[VOLUME_KINDS] = {0, 7.6, 14, 12.5, 7.4};  ///< beside that of the box, by kind
constexpr double block_cost = 14;                                       ///< of a block of primitives: spheres 6, frusta 16, triangles 19
constexpr uint serial_below = 4096;                                     ///< references of a subtree that is one task

/// A node while it is built.
struct VolumeGroup {
    std::unique_ptr<VolumeGroup> children[2];  ///< both or none
    uint begin, end;                           ///< its references, a range of the order
    Bounds bounds;
    uint volume_kind = VOLUME_NONE;
    Volume volume{};
    double cost = 0;  ///< expected, of a ray that meets the box: J where there is no volume inside, B + m/n J where there is one
};

double half_area(const Bounds &bounds) {
    const glm::dvec3 size = glm::dvec3(bounds.high) - glm::dvec3(bounds.low);
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// Of a group at one point some are not.
bool is_finite(const Volume &volume) {
    return std::all_of(std::begin(volume.words), std::end(volume.words), [](float word) { return std::isfinite(word); });
}

class VolumeBuild {
public:
    VolumeBuild(std::span<const Reference> references, const Hulls &hulls, BuildProgress &progress)
        : references_(references), progress_(progress), order_(references.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        starts_.push_back(0);
        for (uint i = 0; i < references.size(); ++i) {
            const Hull hull = hulls(i);
            starts_.push_back(starts_.back() + hull.count);
            parts_.insert(parts_.end(), hull.parts.begin(), hull.parts.begin() + hull.count);
        }
    }

    std::unique_ptr<VolumeGroup> build() { return build(0, uint(order_.size())); }
    const std::vector<uint> &order() const { return order_; }

private:
    std::unique_ptr<VolumeGroup> build(uint begin, uint end) {
        auto group = std::make_unique<VolumeGroup>();
        group->begin = begin, group->end = end;
        for (uint i = begin; i < end; ++i) group->bounds.add(references_[order_[i]].bounds);
        if (const uint middle = cut(*group); middle > begin) {
            const auto first = [&] { group->children[0] = build(begin, middle); };
            const auto second = [&] { group->children[1] = build(middle, end); };
            if (end - begin < serial_below)
                first(), second();
            else
                tbb::parallel_invoke(first, second);
        }
        choose_volume(*group);
        progress_.add(end - begin);
        return group;
    }

    bool one_kind(const VolumeGroup &group) const {
        const auto same = [&](uint a) { return references_[a].kind == references_[order_[group.begin]].kind; };
        return std::all_of(order_.begin() + group.begin, order_.begin() + group.end, same);
    }

    /// Where the second half begins, in whole blocks; the group's begin if it is one block. What would fit a block but for its kinds is cut between
    /// them.
    uint cut(const VolumeGroup &group) {
        const uint count = group.end - group.begin;
        const auto first = order_.begin() + group.begin, last = order_.begin() + group.end;
        if (count <= BLOCK_SIZE) {
            if (one_kind(group)) return group.begin;
            std::sort(first, last, [&](uint a, uint b) { return std::pair(references_[a].kind, a) < std::pair(references_[b].kind, b); });
            const uint kind = references_[*first].kind;
            return uint(std::find_if(first, last, [&](uint a) { return references_[a].kind != kind; }) - order_.begin());
        }
        const auto middle = first + (count / 2 + BLOCK_SIZE - 1) / BLOCK_SIZE * BLOCK_SIZE;
        const int axis = longest_axis(group);
        const auto centre = [&](uint a) { return double(references_[a].bounds.low[axis]) + references_[a].bounds.high[axis]; };
        std::nth_element(first, middle, last, [&](uint a, uint b) { return std::pair(centre(a), a) < std::pair(centre(b), b); });
        return uint(middle - order_.begin());
    }

    /// Along which the middles of the references' boxes lie farthest apart.
    int longest_axis(const VolumeGroup &group) const {
        Bounds centres;
        for (uint i = group.begin; i < group.end; ++i) {
            const Bounds &bounds = references_[order_[i]].bounds;
            centres.add(0.5f * bounds.low + 0.5f * bounds.high);
        }
        const vec3 size = centres.high - centres.low;
        return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    }

    /// T = n B + m J: of n rays that meet the box, tested at cost B, m meet the volume and pay J (Weghorst, Hooper and Greenberg 1984, section 3).
    void choose_volume(VolumeGroup &group) const {
        double inside = block_cost;
        if (group.children[0]) {
            inside = 2 * box_cost;
            for (const auto &child : group.children) inside += part_of_rays(child->bounds, group.bounds) * child->cost;
        }
        group.cost = inside;
        const FittedVolumes volumes = fit_volumes(parts_of(group));
        for (uint kind = VOLUME_NONE + 1; kind < VOLUME_KINDS; ++kind) {
            if (volume_costs[kind] >= group.cost || !is_finite(volumes[kind])) continue;
            const double cost = volume_costs[kind] + part_of_lines(kind, volumes[kind], group.bounds) * inside;
            if (cost < group.cost) group.cost = cost, group.volume_kind = kind, group.volume = volumes[kind];
        }
    }

    static double part_of_rays(const Bounds &part, const Bounds &whole) {
        const double area = half_area(whole);
        return area > 0 ? half_area(part) / area : 1;
    }

    std::vector<HullPart> parts_of(const VolumeGroup &group) const {
        std::vector<HullPart> parts;
        for (uint i = group.begin; i < group.end; ++i)
            parts.insert(parts.end(), parts_.begin() + starts_[order_[i]], parts_.begin() + starts_[order_[i] + 1]);
        return parts;
    }

    std::span<const Reference> references_;
    BuildProgress &progress_;
    std::vector<uint> order_;
    std::vector<uint> starts_;  ///< of the references' parts
    std::vector<HullPart> parts_;
};

struct Flattened {
    std::array<std::vector<PrimitiveBlock>, MAX_PRIMITIVE_KINDS> blocks;
    std::vector<VolumeNode> nodes;
    std::vector<Volume> volumes;
};

class Flattening {
public:
    Flattening(std::span<const Reference> references, const std::vector<uint> &order) : references_(references), order_(order) {}

    /// Depth first, two children at adjacent places.
    void put(const VolumeGroup &group, uint place) {
        VolumeNode node{group.bounds.low, group.bounds.high, 0, group.volume_kind};
        if (group.volume_kind != VOLUME_NONE) {
            node.volume |= uint(flat_.volumes.size()) << VOLUME_PLACE_SHIFT;
            flat_.volumes.push_back(group.volume);
        }
        if (group.children[0]) {
            node.children = uint(flat_.nodes.size());
            flat_.nodes.resize(flat_.nodes.size() + 2);
            put(*group.children[0], node.children), put(*group.children[1], node.children + 1);
        } else {
            node.children = add_block(group);
        }
        flat_.nodes[place] = node;
    }
    void put_root(const VolumeGroup &root) {
        flat_.nodes.resize(1);
        put(root, 0);
    }
    Flattened take() { return std::move(flat_); }

private:
    uint add_block(const VolumeGroup &group) {
        PrimitiveBlock block{.references = {}, .count = group.end - group.begin};
        std::copy(order_.begin() + group.begin, order_.begin() + group.end, block.references.begin());
        std::sort(block.references.begin(), block.references.begin() + block.count);
        const uint kind = references_[block.references[0]].kind;
        std::vector<PrimitiveBlock> &blocks = flat_.blocks[kind];
        if (blocks.size() == VOLUME_BLOCK)
            throw SceneError(fmt::format("bounding_volumes: cannot hold more than {} blocks of {} primitives of one kind", VOLUME_BLOCK, BLOCK_SIZE));
        blocks.push_back(block);
        return VOLUME_LEAF | kind << VOLUME_KIND_SHIFT | uint(blocks.size() - 1);
    }

    std::span<const Reference> references_;
    const std::vector<uint> &order_;
    Flattened flat_;
};

template <class Record> void append(std::vector<std::byte> &bytes, const std::vector<Record> &records) {
    const auto more = std::as_bytes(std::span(records));
    bytes.insert(bytes.end(), more.begin(), more.end());
}

}  // namespace

BuiltAccelerator build_bounding_volumes(std::span<const Reference> references, const Hulls &hulls, BuildQuality, BuildProgress &progress) {
    progress.begin(references.size() * std::bit_width(references.size() / BLOCK_SIZE + 1));  // about so many levels, each of all
    Flattened flat;
    if (!references.empty()) {
        VolumeBuild build(references, hulls, progress);
        const std::unique_ptr<VolumeGroup> root = build.build();
        Flattening flattening(references, build.order());
        flattening.put_root(*root);
        flat = flattening.take();
    }
    BuiltAccelerator accelerator{.blocks = std::move(flat.blocks), .nodes = {}, .node_count = uint(flat.nodes.size())};
    const VolumeTree tree{uint(flat.nodes.size()), {}};
    append(accelerator.nodes, std::vector{tree}), append(accelerator.nodes, flat.nodes), append(accelerator.nodes, flat.volumes);
    return accelerator;
}

}  // namespace brandung
