/// Cells that divide space, and lists of what is in them. A primitive is in the list of every cell that its box has a part in.
#pragma once
#include "kernels/core/portable.h"

/// A list is of items: blocks of primitives some of which are in the cell. They follow each other; the last one is marked.
#define ITEM_LAST 0x80000000u
#define ITEM_KIND_SHIFT 28u     ///< bits 28..30: the kind's number among those in use
#define ITEM_BLOCK 0x0fffffffu  ///< bits 0..27: the block
#define NO_ITEMS 0xffffffffu    ///< stands for the list of an empty cell; no item is all ones, nor is its place

/// Begins what such an accelerator has in the arena; places are in words from there on.
typedef struct {
    uint cells;  ///< place of the cells or nodes, the accelerator's own
    uint items;  ///< place of the items
    uint lanes;  ///< place of a byte per item: bits of the block's primitives that are in the cell. Only those who count read them
} CellSpans;
