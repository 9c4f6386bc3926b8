/// Generated lists: what a scene uses, as virtual kernel files. What is not listed is not compiled.
#pragma once
#include "runtime/opencl/source.h"
#include "scene/compile.h"

namespace brandung {

/// Of a ray that is traced alone: eight are tested against as many boxes or primitives at once, one against one after another.
enum class RayLanes { eight, one };

/// The text of generated/*.cl and generated/*.h for the kinds that the scene uses. One lane only where the accelerator has a scalar traversal.
Sources specialize(const CompiledScene &scene, RayLanes lanes);

/// Children per ray: mirrored and refracted ones need two slots, mirrored ones alone one, none at all none. Of paths one; 2 stands for bundles of any
/// size.
uint branching(const CompiledScene &scene);

}  // namespace brandung
