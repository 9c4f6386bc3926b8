// Several rays in turn, by the accelerator in use: those that trace so have a file for it, which gives
//   Course, course_of(scene)                  what the steps of all rays need
//   Traversal                                 a ray and how far it is
//   closest_begin(course, traversal, prepared, lane, ray), any_begin(...) without the ray: `prepared` must stay where it is
//   upcoming(course, traversal)               a word for what the ray meets next, which then is on its way to the processor
//   next_of(course, word)                     NEXT_...; without instances is_node(word), is_leaf(word) and is_through(word) tell the same
//   closest_node_step(course, traversal), ..._leaf_step, ..._block_step, ..._instance_step, ..._leave, any_...: meets it
// A ray that is through has what it has met in traversal->nearest, after any_... just whether it has met anything.
// In each round every ray makes one step. Which rays come to a node, to a leaf or to their end is sorted out first, without branches, because a
// processor guesses wrong every other time; then all nodes are met, and all leaves. So while one ray's step waits for memory or for its own
// arithmetic, those of the next rays are under way.
#pragma once
#include "kernels/accelerators/levels.cl"
#include "kernels/accelerators/rays_in_turn.cl"

#define NEXT_NODE 0u
#define NEXT_LEAF 1u      ///< primitives
#define NEXT_BLOCK 2u     ///< boxes of instances
#define NEXT_INSTANCE 3u  ///< one that the ray enters
#define NEXT_LEAVE 4u     ///< the end of the one that it is in
#define NEXT_THROUGH 5u   ///< nothing
#define NEXT_KINDS 6u

#include "generated/interleaved_accelerator.cl"

#define RAYS_IN_TURN 24u

typedef struct {
    Traversal *running[RAYS_IN_TURN + 1u], *lists[NEXT_KINDS][RAYS_IN_TURN + 1u];  ///< with room for one that is stored but does not count
    uint running_count;
    ulong counts;  ///< of the lists, 8 bits each
} Turns;

FUNCTION uint count_of(ulong counts, uint kind) { return counts >> 8u * kind & 0xffu; }

/// By what they meet next. Where that is one of three, counts of their own are quicker than a table of kinds.
FUNCTION void sort_running(const Course *course, Turns *turns) {
    uint running = 0u, nodes = 0u, leaves = 0u, through = 0u;
    ulong counts = 0ul;
    for (uint k = 0u; k < turns->running_count; ++k) {
        Traversal *traversal = turns->running[k];
        const uint word = upcoming(course, traversal);
        turns->running[running] = traversal, running += !is_through(word);
        if (INSTANCES) {
            const uint kind = next_of(course, word);
            turns->lists[kind][count_of(counts, kind)] = traversal, counts += 1ul << 8u * kind;
        } else {
            turns->lists[NEXT_THROUGH][through] = traversal, through += is_through(word);
            turns->lists[NEXT_LEAF][leaves] = traversal, leaves += is_leaf(word);
            turns->lists[NEXT_NODE][nodes] = traversal, nodes += is_node(word);
        }
    }
    turns->running_count = running;
    turns->counts = INSTANCES ? counts : (ulong)nodes << 8u * NEXT_NODE | (ulong)leaves << 8u * NEXT_LEAF | (ulong)through << 8u * NEXT_THROUGH;
}

/// Its ray begins, at the root.
FUNCTION void let_run(Turns *turns, Traversal *traversal) {
    turns->running[turns->running_count++] = traversal;
    turns->lists[NEXT_NODE][count_of(turns->counts, NEXT_NODE)] = traversal, turns->counts += 1ul << 8u * NEXT_NODE;
}

#define STEPS_IN_TURN(next, step, course) \
    for (uint k_ = 0u; k_ < count_of(turns_.counts, next); ++k_) step(course, turns_.lists[next][k_]);

/// Rays next ... end - 1: BEGIN(traversal, i) lets ray i begin, END(traversal, i) takes its answer; `kind`: of its steps, closest or any. They begin
/// in their order and end in any.
#define TRACE_IN_TURN(next, end, course, BEGIN, kind, END)                                                                        \
    Traversal traversals_[RAYS_IN_TURN];                                                                                          \
    PreparedRays inside_[(RAYS_IN_TURN + ROW - 1u) / ROW];                                                                        \
    Turns turns_;                                                                                                                 \
    turns_.running_count = 0u;                                                                                                    \
    turns_.counts = 0ul;                                                                                                          \
    for (; turns_.running_count < RAYS_IN_TURN && next < end; ++next) {                                                           \
        Traversal *traversal_ = traversals_ + turns_.running_count;                                                               \
        if (INSTANCES) traversal_->inside = inside_ + turns_.running_count / ROW, traversal_->place = turns_.running_count % ROW; \
        BEGIN(traversal_, next);                                                                                                  \
        traversal_->number = next;                                                                                                \
        let_run(&turns_, traversal_);                                                                                             \
    }                                                                                                                             \
    while (turns_.running_count > 0u) {                                                                                           \
        STEPS_IN_TURN(NEXT_NODE, kind##_node_step, course)                                                                        \
        STEPS_IN_TURN(NEXT_LEAF, kind##_leaf_step, course)                                                                        \
        if (INSTANCES) {                                                                                                          \
            STEPS_IN_TURN(NEXT_BLOCK, kind##_block_step, course)                                                                  \
            STEPS_IN_TURN(NEXT_INSTANCE, kind##_instance_step, course)                                                            \
            STEPS_IN_TURN(NEXT_LEAVE, kind##_leave, course)                                                                       \
        }                                                                                                                         \
        sort_running(course, &turns_);                                                                                            \
        for (uint k_ = 0u; k_ < count_of(turns_.counts, NEXT_THROUGH); ++k_) {                                                    \
            Traversal *traversal_ = turns_.lists[NEXT_THROUGH][k_];                                                               \
            END(traversal_, traversal_->number);                                                                                  \
            if (next == end) continue;                                                                                            \
            BEGIN(traversal_, next);                                                                                              \
            traversal_->number = next++;                                                                                          \
            let_run(&turns_, traversal_);                                                                                         \
        }                                                                                                                         \
    }
