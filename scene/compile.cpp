#include "scene/compile.h"

#include "scene/compilation/parts.h"

namespace brandung {

CompiledScene compile(const Scene &scene) {
    CompiledScene compiled;
    compiled.warnings = scene.warnings;
    Arena arena(compiled.arena);
    add_primitives(scene, compiled, arena);
    add_materials(scene, compiled, arena);
    add_lights(scene, compiled, arena);
    compiled.filter = scene.film.filter;
    compiled.header.background = scene.background;
    compiled.header.ambient = scene.ambient;
    return compiled;
}

}  // namespace brandung
