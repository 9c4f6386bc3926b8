# embed_kernels(VARIABLE): writes a C++ file that defines embedded_kernels() (runtime/opencl/embedded_kernels.h) with the
# text of kernels/**/*.{h,cl}, and sets VARIABLE to its path. A changed or added kernel runs CMake again, which rewrites it.

function(embed_kernels variable)
    set(root ${PROJECT_SOURCE_DIR})
    file(GLOB_RECURSE files RELATIVE ${root} CONFIGURE_DEPENDS ${root}/kernels/*.h ${root}/kernels/*.cl)
    list(SORT files)
    set(entries "")
    foreach(file IN LISTS files)
        text_literals(${root}/${file} literals)
        string(APPEND entries "    {\"${file}\", ${literals}sv},\n")
    endforeach()

    set(output ${PROJECT_BINARY_DIR}/generated/embedded_kernels.cpp)
    file(WRITE ${output}.new
"#include \"runtime/opencl/embedded_kernels.h\"

namespace brandung {
using namespace std::string_view_literals;

static constexpr EmbeddedFile files[] = {
${entries}};

std::span<const EmbeddedFile> embedded_kernels() { return files; }

}  // namespace brandung
")
    file(COPY_FILE ${output}.new ${output} ONLY_IF_DIFFERENT)
    set(${variable} ${output} PARENT_SCOPE)
endfunction()
