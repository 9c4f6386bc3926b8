// Several rays in turn, by the accelerator in use: those that trace so have a file for it, which gives
//   Course, course_of(scene)                  what the steps of all rays need
//   Traversal                                 a ray and how far it is
//   begin(course, traversal, prepared, lane)  `prepared` must stay where it is
//   upcoming(course, traversal)               a word for what the ray meets next, on its way to the processor: is_node(word), or else a leaf
//   is_through(traversal)                     nothing; traversal->nearest is what it has met, after any_leaf_step just whether it has met anything
//   closest_node_step(course, traversal), closest_leaf_step, any_node_step, any_leaf_step: meets it
// In each round every ray makes one step. Which rays come to a node, to a leaf or to their end is sorted out first, without branches, because a
// processor guesses wrong every other time; then all nodes are met, and all leaves. So while one ray's step waits for memory or for its own
// arithmetic, those of the next rays are under way.
#pragma once
#include "kernels/accelerators/levels.cl"
#include "kernels/accelerators/rays_in_turn.cl"

#include "generated/interleaved_accelerator.cl"

#define RAYS_IN_TURN 16u

/// Lists of traversals, with room for one that is stored but does not count.
typedef struct {
    Traversal *running[RAYS_IN_TURN + 1u], *nodes[RAYS_IN_TURN + 1u], *leaves[RAYS_IN_TURN + 1u], *through[RAYS_IN_TURN + 1u];
    uint running_count, node_count, leaf_count, through_count;
} Turns;

/// By what they meet next.
FUNCTION void sort_running(const Course *course, Turns *turns) {
    uint running = 0u, nodes = 0u, leaves = 0u, through = 0u;
    for (uint k = 0u; k < turns->running_count; ++k) {
        Traversal *traversal = turns->running[k];
        const uint word = upcoming(course, traversal);
        const bool runs = !is_through(traversal), node = is_node(word);
        turns->through[through] = traversal, through += !runs;
        turns->running[running] = traversal, running += runs;
        turns->leaves[leaves] = traversal, leaves += runs & !node;
        turns->nodes[nodes] = traversal, nodes += runs & node;
    }
    turns->running_count = running, turns->node_count = nodes, turns->leaf_count = leaves, turns->through_count = through;
}

/// Its ray begins, at the root.
FUNCTION void let_run(Turns *turns, Traversal *traversal) {
    turns->running[turns->running_count++] = traversal;
    turns->nodes[turns->node_count++] = traversal;
}

/// Rays next ... end - 1: BEGIN(traversal, i) lets ray i begin, NODE_STEP(traversal) and LEAF_STEP make a step, END(traversal, i) takes its answer.
/// They begin in their order and end in any.
#define TRACE_IN_TURN(next, end, course, BEGIN, NODE_STEP, LEAF_STEP, END)             \
    Traversal traversals_[RAYS_IN_TURN];                                               \
    Turns turns_;                                                                      \
    turns_.running_count = 0u, turns_.node_count = 0u, turns_.leaf_count = 0u;         \
    for (; turns_.running_count < RAYS_IN_TURN && next < end; ++next) {                \
        Traversal *traversal_ = traversals_ + turns_.running_count;                    \
        BEGIN(traversal_, next);                                                       \
        traversal_->number = next;                                                     \
        let_run(&turns_, traversal_);                                                  \
    }                                                                                  \
    while (turns_.running_count > 0u) {                                                \
        for (uint k_ = 0u; k_ < turns_.node_count; ++k_) NODE_STEP(turns_.nodes[k_]);  \
        for (uint k_ = 0u; k_ < turns_.leaf_count; ++k_) LEAF_STEP(turns_.leaves[k_]); \
        sort_running(course, &turns_);                                                 \
        for (uint k_ = 0u; k_ < turns_.through_count; ++k_) {                          \
            Traversal *traversal_ = turns_.through[k_];                                \
            END(traversal_, traversal_->number);                                       \
            if (next == end) continue;                                                 \
            BEGIN(traversal_, next);                                                   \
            traversal_->number = next++;                                               \
            let_run(&turns_, traversal_);                                              \
        }                                                                              \
    }
