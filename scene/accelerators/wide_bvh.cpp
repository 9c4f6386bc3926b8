/// Collapses the binary hierarchy to nodes with 8 children.
#include "scene/accelerators/wide_bvh.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "kernels/core/items.h"
#include "scene/accelerators/bvh2.h"
#include "scene/accelerators/reinsertion.h"
#include "scene/accelerators/wide_cut.h"
#include "scene/error.h"

namespace brandung {
namespace {

constexpr uint most_slack = 16;
static_assert(std::bit_width(MAX_PRIMITIVES - 1) <= BVH_LEVELS, "a balanced tree over all that have numbers is not too deep");
constexpr uint piece_size = 16384;         ///< references of a subtree that is one task
constexpr uint high_smallest_divided = 5;  ///< for quality high; offering smaller blocks in pieces gains next to nothing

/// The hierarchy to collapse, and how.
struct BinaryTree {
    const Bvh2 &nodes;
    LargeArray<Cut> cuts;
};

struct Children {
    std::array<uint, BVH_WIDTH> nodes;  // of the binary tree
    uint count = 0;
};

void add_children(const BinaryTree &tree, uint index, uint width, Children &children) {
    const uint first_share = tree.cuts[index].shares[width];
    if (first_share == 0) {
        children.nodes[children.count++] = index;
        return;
    }
    const uint first = tree.nodes.nodes[index].children;
    add_children(tree, first, first_share, children);
    add_children(tree, first + 1, width - first_share, children);
}

/// Largest first.
Children children_of(const BinaryTree &tree, uint index) {
    Children children;
    if (tree.cuts[index].is_leaf) {
        children = {.nodes = {index}, .count = 1};  // only the root has a node nevertheless
    } else {
        add_children(tree, index, BVH_WIDTH, children);
    }
    // An insertion sort: stable, and without the memory that std::stable_sort takes.
    const auto size = [&](uint node) { return tree.nodes.nodes[node].count; };
    for (uint i = 1; i < children.count; ++i)
        for (uint j = i; j > 0 && size(children.nodes[j - 1]) < size(children.nodes[j]); --j) std::swap(children.nodes[j - 1], children.nodes[j]);
    return children;
}

BvhNode empty_node() {
    BvhNode node{};
    for (auto &low : node.low) std::fill(std::begin(low), std::end(low), std::numeric_limits<float>::infinity());
    for (auto &high : node.high) std::fill(std::begin(high), std::end(high), -std::numeric_limits<float>::infinity());
    std::fill(std::begin(node.child), std::end(node.child), BVH_EMPTY);
    return node;
}

void set_child(BvhNode &node, uint slot, const KindBox &box, uint word) {
    node.child[slot] = word;
    for (uint axis = 0; axis < 3; ++axis) {
        node.low[axis][slot] = box.low[axis];
        node.high[axis][slot] = box.high[axis];
    }
}

/// That of a ray to a node or leaf, if it meets all boxes on it and visits the children in the worst order.
struct Way {
    uint levels = 0;         ///< nodes that it comes through
    uint stack_entries = 1;  ///< children of these that still wait, and where it leads

    Way to_child(uint children) const { return {levels + 1, stack_entries + children - 1}; }
    Way or_longer(const Way &other) const { return {std::max(levels, other.levels), std::max(stack_entries, other.stack_entries)}; }
};

/// Wide nodes below one node of the binary tree, depth first, so that what is near in space is near in memory. Words of children number nodes and
/// blocks from this piece's first on.
class Piece {
public:
    Piece(const BinaryTree &tree, uint root, Way way) : tree_(tree), root_(root), way_(way) {}

    void build(BuildProgress &progress) {
        word = tree_.cuts[root_].is_leaf && root_ != 0 ? add_block(root_) : add_node(root_, way_);
        std::uint64_t references = 0;
        for (const auto &of_kind : blocks)
            for (const PrimitiveBlock &block : of_kind) references += block.count;
        progress.add(references);
    }

    uint word;  ///< of its root
    std::vector<BvhNode> nodes;
    std::array<std::vector<PrimitiveBlock>, MAX_PRIMITIVE_KINDS> blocks;
    Way longest;  ///< to the children of its nodes

private:
    /// `way`: to this node.
    uint add_node(uint index, Way way) {
        const Children children = children_of(tree_, index);
        const uint place = uint(nodes.size());
        nodes.push_back(empty_node());
        way = way.to_child(children.count);
        longest = longest.or_longer(way);
        for (uint slot = 0; slot < children.count; ++slot) {
            const uint child = children.nodes[slot];
            const uint word = tree_.cuts[child].is_leaf ? add_block(child) : add_node(child, way);
            set_child(nodes[place], slot, tree_.nodes.nodes[child].box, word);
        }
        return place;
    }
    uint add_block(uint index) {
        const uint kind = tree_.nodes.nodes[index].box.kind();
        PrimitiveBlock block{.references = {}, .count = 0};
        add_references(index, block);
        std::sort(block.references.begin(), block.references.begin() + block.count);
        blocks[kind].push_back(block);
        return BVH_LEAF | kind << BVH_KIND_SHIFT | uint(blocks[kind].size() - 1);
    }
    void add_references(uint index, PrimitiveBlock &block) const {
        const Bvh2Node &node = tree_.nodes.nodes[index];
        if (node.children != 0) {
            add_references(node.children, block), add_references(node.children + 1, block);
        } else {
            for (uint i = 0; i < node.count; ++i) block.references[block.count++] = tree_.nodes.references[node.first + i].index;
        }
    }

    const BinaryTree &tree_;
    uint root_;
    Way way_;
};

/// The top of the tree, and pieces of it below, which are built in parallel. Everything gets the number that it would have in one piece.
class Collapse {
public:
    Collapse(const Bvh2 &tree, BuildProgress &progress) : tree_{tree, cut_tree(tree)} {
        list_pieces(0, {});
        tbb::parallel_for(
            size_t(0), pieces_.size(), [&](size_t i) { pieces_[i].build(progress); }, tbb::simple_partitioner());
        for (const Piece &piece : pieces_) longest_ = longest_.or_longer(piece.longest);
    }

    bool fits(const WideBvhLimits &limits) const { return longest_.levels <= limits.levels && longest_.stack_entries <= limits.pending; }

    BuiltAccelerator join() {
        add(0);
        BuiltAccelerator built;
        built.nodes.resize(node_count_ * sizeof(BvhNode)), built.node_count = node_count_;
        for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) {
            if (block_counts_[kind] > BVH_BLOCK)  // the word of one more would be BVH_EMPTY in the last kind
                throw SceneError(fmt::format("wide_bvh: cannot hold more than {} blocks of {} primitives of one kind", BVH_BLOCK, BLOCK_SIZE));
            built.blocks[kind].resize(block_counts_[kind]);
        }
        BvhNode *nodes = reinterpret_cast<BvhNode *>(built.nodes.data());
        for (const auto &[place, node] : top_) nodes[place] = node;
        tbb::parallel_for(size_t(0), pieces_.size(), [&](size_t i) { put(pieces_[i], firsts_[i], nodes, built); });
        built.blocks_at_root = std::ranges::any_of(nodes[0].child, [](uint word) { return word >= BVH_LEAF && word != BVH_EMPTY; });
        return built;
    }

private:
    /// Numbers of a piece's first node and blocks.
    struct Firsts {
        uint node;
        std::array<uint, MAX_PRIMITIVE_KINDS> blocks;
    };

    bool is_piece(uint index) const { return tree_.nodes.nodes[index].count <= piece_size; }

    void list_pieces(uint index, Way way) {
        if (is_piece(index)) {
            pieces_.emplace_back(tree_, index, way);
            return;
        }
        const Children children = children_of(tree_, index);
        way = way.to_child(children.count);
        longest_ = longest_.or_longer(way);
        for (uint slot = 0; slot < children.count; ++slot) list_pieces(children.nodes[slot], way);
    }

    /// In the same order. Gives the word.
    uint add(uint index) {
        if (is_piece(index)) {
            const Piece &piece = pieces_[firsts_.size()];
            firsts_.push_back({node_count_, block_counts_});
            node_count_ += uint(piece.nodes.size());
            for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) block_counts_[kind] += uint(piece.blocks[kind].size());
            return moved(piece.word, firsts_.back());
        }
        const Children children = children_of(tree_, index);
        const uint place = node_count_++;
        BvhNode node = empty_node();
        for (uint slot = 0; slot < children.count; ++slot)
            set_child(node, slot, tree_.nodes.nodes[children.nodes[slot]].box, add(children.nodes[slot]));
        top_.emplace_back(place, node);
        return place;
    }
    static uint moved(uint word, const Firsts &firsts) {
        if (word == BVH_EMPTY) return word;
        return word + ((word & BVH_LEAF) != 0 ? firsts.blocks[word >> BVH_KIND_SHIFT & 7u] : firsts.node);
    }
    static void put(const Piece &piece, const Firsts &firsts, BvhNode *nodes, BuiltAccelerator &built) {
        for (size_t i = 0; i < piece.nodes.size(); ++i) {
            BvhNode &node = nodes[firsts.node + i] = piece.nodes[i];
            for (uint &word : node.child) word = moved(word, firsts);
        }
        for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind)
            std::ranges::copy(piece.blocks[kind], built.blocks[kind].begin() + firsts.blocks[kind]);
    }

    BinaryTree tree_;
    std::vector<Piece> pieces_;
    std::vector<Firsts> firsts_;                 ///< of the pieces
    std::vector<std::pair<uint, BvhNode>> top_;  ///< nodes above them, by place
    std::array<uint, MAX_PRIMITIVE_KINDS> block_counts_{};
    uint node_count_ = 0;
    Way longest_;
};

BuiltAccelerator build_empty() {
    const BvhNode root = empty_node();
    const auto bytes = std::as_bytes(std::span(&root, 1));
    BuiltAccelerator built;
    built.nodes.assign(bytes.begin(), bytes.end()), built.node_count = 1;
    return built;
}

Bvh2 build_binary(std::span<const Reference> references, BuildQuality quality, uint slack, BuildProgress &progress) {
    if (quality == BuildQuality::fast) return build_bvh2(references, {.slack = slack}, progress);
    Bvh2 tree = build_bvh2(references, {.slack = slack, .smallest_divided = high_smallest_divided}, progress);
    reinsert(tree, depth_limit(references.size(), slack), progress);
    return tree;
}

}  // namespace

BuiltAccelerator build_wide_bvh_within(const WideBvhLimits &limits, std::span<const Reference> references, BuildQuality quality,
                                       BuildProgress &progress) {
    if (references.empty()) return build_empty();
    // The binary tree, rounds of changes to it, and its collapse.
    progress.begin((quality == BuildQuality::high ? 2 + reinsertion_rounds : 2) * references.size());
    // Only nests of boxes that grow without end make the first tree too deep.
    for (uint slack = most_slack;; slack /= 2) {
        const Bvh2 tree = build_binary(references, quality, slack, progress);
        Collapse collapse(tree, progress);
        if (collapse.fits(limits)) return collapse.join();
        if (slack == 0) throw SceneError(fmt::format("wide_bvh: {} primitives need a deeper stack than the traversal has", references.size()));
    }
}

BuiltAccelerator build_wide_bvh(std::span<const Reference> references, const Hulls &, BuildQuality quality, BuildProgress &progress) {
    return build_wide_bvh_within({}, references, quality, progress);
}

}  // namespace brandung
