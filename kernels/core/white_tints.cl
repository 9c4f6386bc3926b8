// What colours nothing.
#pragma once
#include "kernels/core/items.h"

FUNCTION Tints white_tints() {
    const Tints white = {{1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    return white;
}
