/// Generated lists: what a scene uses, as virtual kernel files. What is not listed is not compiled.
#pragma once
#include "runtime/opencl/source.h"
#include "scene/compile.h"

namespace brandung {

/// The text of generated/*.cl and generated/*.h for the kinds that the scene uses.
Sources specialize(const CompiledScene &scene);

/// Children per ray: mirrored and refracted ones need two slots, mirrored ones alone one, none at all none.
uint branching(const CompiledScene &scene);

}  // namespace brandung
