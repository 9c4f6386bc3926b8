// Mailboxes: which blocks a ray has tested already, so that what lies in several cells is tested once. Instead of a ray's number in every primitive
// (Amanatides and Woo 1987, section 3), which rays traced side by side would overwrite, the ray itself keeps the last few, as Shevtsov, Soupikov and
// Kapustin do (Highly Parallel Fast KD-tree Construction, Eurographics 2007, section 4). What falls out of it is
// tested again, to the same end: once only is promised to the blocks of lists that are not longer than the mailbox.
#pragma once
#include "kernels/accelerators/cells.h"

#define MAILBOX_SIZE 16u

typedef struct {
    uint items[MAILBOX_SIZE];
} Mailbox;

FUNCTION void mailbox_empty(Mailbox *mailbox) {
    for (uint i = 0u; i < MAILBOX_SIZE; ++i) mailbox->items[i] = NO_ITEMS;
}

/// Whether the item is new, and from now on it is not. Neighbouring blocks have places of their own.
FUNCTION bool mailbox_add(Mailbox *mailbox, uint item) {
    uint *place = mailbox->items + item % MAILBOX_SIZE;
    if (*place == item) return false;
    *place = item;
    return true;
}
