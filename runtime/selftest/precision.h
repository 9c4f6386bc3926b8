/// In which precision kernels under kernels/selftest/ are built.
#pragma once
#include <optional>

#include "kernels/core/scene.h"
#include "runtime/opencl/kernel.h"

namespace brandung {

/// A kernel whose file begins with generated/precision.cl, in float and in double, which shows what rounding alone does.
struct KernelInBoth {
    /// Builds it, with what else is generated for it; in double if the device has them and they are of use. Throws Error.
    KernelInBoth(Device &device, const std::string &file, const std::string &name, const Sources &generated = {}, bool is_rounded = true)
        : in_float(device, file, name, with_precision(generated, "// float\n")) {
        if (device.info().doubles && is_rounded)
            in_double.emplace(device, file, name, with_precision(generated, "#include \"kernels/selftest/in_double.cl\"\n"));
    }

    Kernel in_float;
    std::optional<Kernel> in_double;

private:
    static Sources with_precision(Sources generated, const char *text) {
        generated["generated/precision.cl"] = text;
        return generated;
    }
};

/// A scene's header in either precision, whose spans begin at 0: the arena is the one table that a kernel reads.
inline Buffer<std::byte> empty_header(Device &device) {
    Buffer<std::byte> header(device, 2 * sizeof(SceneHeader));
    header.fill_zero();
    return header;
}

}  // namespace brandung
