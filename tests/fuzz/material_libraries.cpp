/// Fuzzes the reader of material libraries, and what their materials become.
#include "scene/meshes/mtl.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    const std::string file = write_input(data, size, ".mtl");
    try {
        brandung::Scene scene;
        for (const brandung::MtlMaterial &material : brandung::read_mtl(file, scene)) brandung::make_material(material, scene.warnings);
    } catch (const brandung::SceneError &) {
    }
    return 0;
}
