#include "runtime/opencl/error.h"

#include <CL/cl.h>

#include <map>

namespace brandung {

std::string status_name(int status) {
#define NAME(code) \
    { code, #code }
    static const std::map<int, const char *> names = {
        NAME(CL_DEVICE_NOT_FOUND),        NAME(CL_DEVICE_NOT_AVAILABLE),     NAME(CL_COMPILER_NOT_AVAILABLE), NAME(CL_MEM_OBJECT_ALLOCATION_FAILURE),
        NAME(CL_OUT_OF_RESOURCES),        NAME(CL_OUT_OF_HOST_MEMORY),       NAME(CL_BUILD_PROGRAM_FAILURE),  NAME(CL_INVALID_VALUE),
        NAME(CL_INVALID_DEVICE),          NAME(CL_INVALID_BUFFER_SIZE),      NAME(CL_INVALID_BUILD_OPTIONS),  NAME(CL_INVALID_KERNEL_NAME),
        NAME(CL_INVALID_ARG_INDEX),       NAME(CL_INVALID_ARG_VALUE),        NAME(CL_INVALID_ARG_SIZE),       NAME(CL_INVALID_KERNEL_ARGS),
        NAME(CL_INVALID_WORK_GROUP_SIZE), NAME(CL_INVALID_GLOBAL_WORK_SIZE), NAME(CL_INVALID_OPERATION),      {-1001, "CL_PLATFORM_NOT_FOUND_KHR"},
    };
#undef NAME
    const auto name = names.find(status);
    return name == names.end() ? "status " + std::to_string(status) : name->second;
}

}  // namespace brandung
