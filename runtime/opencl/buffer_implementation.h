/// What a RawBuffer is made of; for this folder only.
#pragma once
#include "runtime/opencl/buffer.h"
#include "runtime/opencl/implementation.h"

namespace brandung {

struct RawBuffer::Implementation {
    cl::Buffer memory;
};

}  // namespace brandung
