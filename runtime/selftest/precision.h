/// In which precision kernels under kernels/selftest/ are built.
#pragma once
#include "runtime/opencl/source.h"

namespace brandung {

/// Their generated file that makes floats of the source doubles, or does not.
inline Sources::value_type precision(bool in_double) {
    return {"generated/precision.cl", in_double ? "#include \"kernels/selftest/in_double.cl\"\n" : "// float\n"};
}

}  // namespace brandung
