/// An OpenCL driver with one device, which has a name but reports an error for everything else that it is asked.
#include <CL/cl_icd.h>
#include <string.h>

#define UNUSED __attribute__((unused))

extern cl_icd_dispatch dispatch;

struct _cl_platform_id {
    cl_icd_dispatch *dispatch;
} platform = {&dispatch};

struct _cl_device_id {
    cl_icd_dispatch *dispatch;
} device = {&dispatch};

static cl_int give(const char *text, size_t size, void *value, size_t *size_needed) {
    if (size_needed) *size_needed = strlen(text) + 1;
    if (value && size <= strlen(text)) return CL_INVALID_VALUE;
    if (value) strcpy(value, text);
    return CL_SUCCESS;
}

static cl_int CL_API_CALL get_platforms(cl_uint size, cl_platform_id *platforms, cl_uint *count) {
    if (count) *count = 1;
    if (platforms && size > 0) platforms[0] = &platform;
    return CL_SUCCESS;
}

static cl_int CL_API_CALL get_platform_info(UNUSED cl_platform_id of, cl_platform_info what, size_t size, void *value, size_t *size_needed) {
    switch (what) {
    case CL_PLATFORM_EXTENSIONS: return give("cl_khr_icd", size, value, size_needed);
    case CL_PLATFORM_VERSION: return give("OpenCL 1.2 faulty", size, value, size_needed);
    default: return give("faulty", size, value, size_needed);
    }
}

static cl_int CL_API_CALL get_devices(UNUSED cl_platform_id of, UNUSED cl_device_type type, cl_uint size, cl_device_id *devices, cl_uint *count) {
    if (count) *count = 1;
    if (devices && size > 0) devices[0] = &device;
    return CL_SUCCESS;
}

static cl_int CL_API_CALL get_device_info(UNUSED cl_device_id of, cl_device_info what, size_t size, void *value, size_t *size_needed) {
    return what == CL_DEVICE_NAME ? give("broken accelerator", size, value, size_needed) : CL_OUT_OF_RESOURCES;
}

static cl_int CL_API_CALL keep(UNUSED cl_device_id device) { return CL_SUCCESS; }

cl_icd_dispatch dispatch = {
    .clGetPlatformIDs = get_platforms,
    .clGetPlatformInfo = get_platform_info,
    .clGetDeviceIDs = get_devices,
    .clGetDeviceInfo = get_device_info,
    .clRetainDevice = keep,
    .clReleaseDevice = keep,
};

/// What the loader asks a driver's library for.
void *CL_API_CALL clGetExtensionFunctionAddress(const char *name) {
    if (strcmp(name, "clIcdGetPlatformIDsKHR") == 0) return (void *)get_platforms;
    return strcmp(name, "clGetPlatformInfo") == 0 ? (void *)get_platform_info : NULL;
}
