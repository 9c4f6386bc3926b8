// The material at hits in scenes where some choose among others: choose_materials has found it out.
#pragma once
#include "kernels/core/scene.cl"

/// At hit i, whose primitive has the material `own` in this instance.
FUNCTION uint material_at_hit(const global uint *chosen, uint i, uint own) { return chosen[i]; }
