#include "scene/accelerators/reinsertion.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <vector>

namespace brandung {
namespace {

constexpr uint max_depth = 64;      ///< of any tree: ceil(log2(MAX_PRIMITIVES)) and the most slack are less
constexpr double part_tried = 0.3;  ///< of the nodes, the largest, in each round: they gain the most for the time it takes
constexpr size_t least_tried = 64;  ///< where there are as many

/// A node is taken out with its parent, which its sibling replaces, and a new parent over it and the target is put where the target was.
struct Move {
    float gain = 0;
    uint node = 0, target = 0;
};

KindBox united(KindBox box, const KindBox &other) {
    box.add(other);
    return box;
}

/// Places of two siblings are 2 k + 1 and 2 k + 2. Subtrees change their places as they move.
uint sibling(uint node) { return ((node - 1) ^ 1) + 1; }

class Reinsertion {
public:
    Reinsertion(const Bvh2 &tree, uint depth_limit)
        : area_of_(tree.area_of),
          depth_limit_(depth_limit),
          nodes_(make_large_array<Bvh2Node>(tree.node_count)),
          parents_(tree.node_count),
          heights_(tree.node_count),
          replaced_(tree.node_count) {
        nodes_[0] = tree.nodes[0];
        take_children(tree, 0);
    }

    void do_round(BuildProgress &progress) {
        const std::vector<uint> tried = largest();
        std::vector<Move> moves(tried.size());
        const std::uint64_t references = nodes_[0].count;
        tbb::parallel_for(tbb::blocked_range<size_t>(0, tried.size()), [&](const tbb::blocked_range<size_t> &range) {
            for (size_t i = range.begin(); i < range.end(); ++i) moves[i] = best_move(tried[i]);
            progress.add(range.end() * references / tried.size() - range.begin() * references / tried.size());
        });
        std::erase_if(moves, [](const Move &move) { return move.gain == 0; });
        tbb::parallel_sort(moves.begin(), moves.end(),
                           [](const Move &a, const Move &b) { return a.gain != b.gain ? a.gain > b.gain : a.node < b.node; });
        std::ranges::fill(replaced_, false);
        for (const Move &move : moves) try_move(move);
    }

    LargeArray<Bvh2Node> take_nodes() {
        count_references(0);
        return std::move(nodes_);
    }

private:
    /// Depth first.
    void take_children(const Bvh2 &tree, uint place) {
        const uint from = nodes_[place].children;
        if (from == 0) return;
        const uint to = nodes_[place].children = node_count_;
        node_count_ += 2;
        for (uint side = 0; side < 2; ++side) {
            nodes_[to + side] = tree.nodes[from + side];
            parents_[to + side] = place;
        }
        take_children(tree, to), take_children(tree, to + 1);
        update_height(place);
    }

    float area(const KindBox &box) const { return area_of_(box); }
    float area(uint node) const { return area(nodes_[node].box); }
    bool is_divisible(uint node) const { return nodes_[node].children != 0 && !nodes_[node].fits_block(); }

    std::vector<uint> largest() const {
        std::vector<std::pair<float, uint>> all;
        for (uint i = 1; i < node_count_; ++i)
            if (parents_[i] != 0 && is_divisible(parents_[i])) all.emplace_back(-area(i), i);
        const size_t count = std::min(all.size(), std::max<size_t>(least_tried, size_t(part_tried * double(all.size()))));
        std::ranges::nth_element(all, all.begin() + std::ptrdiff_t(count));
        std::vector<uint> nodes;
        for (size_t i = 0; i < count; ++i) nodes.push_back(all[i].second);
        return nodes;
    }

    /// Looks among the siblings of all nodes above, with what is below them.
    Move best_move(uint node) const {
        Move best{.gain = 0, .node = node, .target = 0};
        const uint parent = parents_[node];
        float gain = area(parent);  // of taking it out, as far as the box of `pivot` shows
        KindBox rest = nodes_[sibling(node)].box;
        try_below(sibling(node), gain, best);
        for (uint pivot = parent; pivot != 0; pivot = parents_[pivot]) {
            if (pivot != parent) try_target(pivot, gain - area(pivot), best);
            try_below(sibling(pivot), gain, best);
            rest.add(nodes_[sibling(pivot)].box);
            gain += area(parents_[pivot]) - area(rest);
        }
        return best;
    }
    static void try_target(uint target, float gain, Move &best) {
        if (gain > best.gain) best.gain = gain, best.target = target;
    }
    /// `gain`: of the node's leaving, less what it costs the nodes above `target` to hold it.
    void try_below(uint target, float gain, Move &best) const {
        const KindBox box = nodes_[best.node].box;
        const float least_cost = area(box);
        struct Entry {
            uint target;
            float gain;
        };
        std::array<Entry, max_depth + 1> stack;
        uint size = 0;
        stack[size++] = {target, gain};
        while (size > 0) {
            const Entry entry = stack[--size];
            if (entry.gain - least_cost <= best.gain) continue;
            const float here = entry.gain - area(united(nodes_[entry.target].box, box));
            try_target(entry.target, here, best);
            if (!is_divisible(entry.target)) continue;
            const uint children = nodes_[entry.target].children;
            stack[size++] = {children + 1, here + area(entry.target)};
            stack[size++] = {children, here + area(entry.target)};
        }
    }

    /// Gains were found in the tree before other moves: one that these have spoilt is undone.
    void try_move(const Move &move) {
        const auto [gain, node, target] = move;
        const uint parent = parents_[node], other = sibling(node);
        if (replaced_[node] || parent == 0 || target == parent || target == other || !may_hang_below(node, target)) return;
        if (reinsert(node, target) >= 0)
            reinsert(node, parent);
        else
            replaced_[target] = replaced_[parent] = replaced_[other] = true;
    }
    bool may_hang_below(uint node, uint target) const {
        uint depth = 1 + std::max(heights_[node], heights_[target]);
        for (uint above = target; above != 0; above = parents_[above], ++depth)
            if (above == node) return false;
        return depth <= depth_limit_;
    }
    /// By how much the areas of all nodes grow.
    double reinsert(uint node, uint target) {
        const uint parent = parents_[node], other = sibling(node);
        double growth = -area(parent);
        move_content(other, parent);
        move_content(target, other);
        nodes_[target].children = std::min(node, other);
        parents_[node] = parents_[other] = target;
        update(target);
        growth += area(target) + update_from(parents_[parent]);
        return target == 0 ? growth : growth + update_from(parents_[target]);
    }
    void move_content(uint from, uint to) {
        nodes_[to] = nodes_[from], heights_[to] = heights_[from];
        if (const uint children = nodes_[to].children) parents_[children] = parents_[children + 1] = to;
    }
    void update_height(uint node) {
        const uint children = nodes_[node].children;
        heights_[node] = 1 + std::max(heights_[children], heights_[children + 1]);
    }
    void update(uint node) {
        const uint children = nodes_[node].children;
        const Bvh2Node &first = nodes_[children], &second = nodes_[children + 1];
        nodes_[node] = {united(first.box, second.box), 0, first.count + second.count, children};
        update_height(node);
    }
    /// Upwards until nothing changes. Numbers of references stay behind; whether a node fits a block they still tell.
    double update_from(uint node) {
        double growth = 0;
        for (;; node = parents_[node]) {
            const KindBox box_before = nodes_[node].box;
            const uint height_before = heights_[node];
            update(node);
            growth += area(node) - area(box_before);
            if (node == 0 || (nodes_[node].box == box_before && heights_[node] == height_before)) return growth;
        }
    }
    uint count_references(uint node) {
        const uint children = nodes_[node].children;
        if (children != 0) nodes_[node].count = count_references(children) + count_references(children + 1);
        return nodes_[node].count;
    }

    RelativeArea area_of_;
    uint depth_limit_;
    LargeArray<Bvh2Node> nodes_;
    uint node_count_ = 1;
    std::vector<uint> parents_, heights_;  ///< height: levels below
    std::vector<char> replaced_;           ///< places at which there is now something else than when the moves were chosen
};

}  // namespace

void reinsert(Bvh2 &tree, uint depth_limit, BuildProgress &progress) {
    Reinsertion reinsertion(tree, depth_limit);
    for (uint round = 0; round < reinsertion_rounds; ++round) reinsertion.do_round(progress);
    tree.nodes = reinsertion.take_nodes();
}

}  // namespace brandung
