# embed_kernels(VARIABLE): writes a C++ file that defines embedded_kernels() (runtime/opencl/embedded_kernels.h) with the
# text of kernels/**/*.{h,cl}, and sets VARIABLE to its path. A changed or added kernel runs CMake again, which rewrites it.

function(embed_kernels variable)
    set(root ${PROJECT_SOURCE_DIR})
    file(GLOB_RECURSE files RELATIVE ${root} CONFIGURE_DEPENDS ${root}/kernels/*.h ${root}/kernels/*.cl)
    list(SORT files)
    set(entries "")
    foreach(file IN LISTS files)
        set_property(DIRECTORY ${root} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/${file})
        file(READ ${root}/${file} text)
        set(literals "")
        # Compilers need not take a literal above 65536 characters, and some stop at 16384.
        string(LENGTH "${text}" length)
        while(length GREATER 12000)
            string(SUBSTRING "${text}" 0 12000 chunk)
            string(FIND "${chunk}" "\n" end REVERSE)
            if(end LESS 0)
                message(FATAL_ERROR "${file} has a line too long to embed")
            endif()
            math(EXPR end "${end} + 1")
            string(SUBSTRING "${text}" 0 ${end} chunk)
            string(SUBSTRING "${text}" ${end} -1 text)
            string(APPEND literals "R\"kernel(${chunk})kernel\"\n")
            string(LENGTH "${text}" length)
        endwhile()
        string(APPEND entries "    {\"${file}\", ${literals}R\"kernel(${text})kernel\"sv},\n")
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
