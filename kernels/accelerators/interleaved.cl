// Several rays in turn, by the accelerator in use: those that trace so have a file for it, which gives
//   Course, course_of(scene)                     what the steps of all rays need
//   Traversal                                    a ray and how far it is
//   begin(course, traversal, ray, instance)      `instance`: that of the primitive which the ray leaves
//   closest_step(course, traversal), any_step    a step; false: the ray is through, and traversal->nearest is what it has met, of any_step
//                                                just whether it has met anything
#pragma once
#include "kernels/accelerators/levels.cl"
#include "kernels/core/ray_x1.cl"

#include "generated/interleaved_accelerator.cl"

#define RAYS_IN_TURN 6u

/// Rays next ... end - 1: BEGIN(traversal, i) lets ray i begin, STEP(traversal) makes a step, END(traversal, i) takes its answer. They begin in their
/// order and end in any.
#define TRACE_IN_TURN(next, end, BEGIN, STEP, END)                                          \
    Traversal traversals_[RAYS_IN_TURN];                                                    \
    uint rays_[RAYS_IN_TURN], order_[RAYS_IN_TURN], running_ = 0u;                          \
    for (; running_ < RAYS_IN_TURN && next < end; ++running_, ++next) {                     \
        order_[running_] = running_, rays_[running_] = next;                                \
        BEGIN(&traversals_[running_], next);                                                \
    }                                                                                       \
    for (uint turn_ = 0u; running_ > 0u; turn_ = turn_ + 1u < running_ ? turn_ + 1u : 0u) { \
        const uint place_ = order_[turn_];                                                  \
        if (STEP(&traversals_[place_])) continue;                                           \
        END(&traversals_[place_], rays_[place_]);                                           \
        if (next < end) {                                                                   \
            rays_[place_] = next;                                                           \
            BEGIN(&traversals_[place_], next);                                              \
            ++next;                                                                         \
        } else {                                                                            \
            order_[turn_] = order_[--running_];                                             \
        }                                                                                   \
    }
