/// Generated lists: what a scene uses, as virtual kernel files. What is not listed is not compiled.
#pragma once
#include "runtime/opencl/source.h"
#include "scene/compile.h"

namespace brandung {

/// Of a ray that is traced alone: eight are tested against as many boxes or primitives at once, one against one after another.
enum class RayLanes { eight, one };

/// When rays see a scene that moves: each at its own time, or all at the first.
enum class Times { of_rays, first };

/// The text of generated/*.cl and generated/*.h for the kinds that the scene uses. One lane only where the accelerator has a scalar traversal.
Sources specialize(const CompiledScene &scene, RayLanes lanes, Times times = Times::of_rays);

/// Children per ray: mirrored and refracted ones need two slots, mirrored ones alone one, none at all none. Of paths one; 2 stands for bundles of any
/// size.
uint branching(const CompiledScene &scene);

}  // namespace brandung
