/// Fuzzes the reader of one format of scenes, that of FUZZ_EXTENSION, and the scene's compilation.
#include "scene/compile.h"
#include "scene/formats/format.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    const std::string file = write_input(data, size, FUZZ_EXTENSION);
    try {
        brandung::compile(brandung::read_scene(file));
    } catch (const brandung::SceneError &) {
    }
    return 0;
}
