# embed_page(FOLDER FUNCTION VARIABLE): writes a C++ file that defines FUNCTION, which FOLDER's page.h declares, with the text of
# FOLDER's page.html, and sets VARIABLE to its path.

function(embed_page folder function variable)
    text_literals(${PROJECT_SOURCE_DIR}/${folder}/page.html literals)
    set(output ${PROJECT_BINARY_DIR}/generated/${function}.cpp)
    file(WRITE ${output}.new
"#include \"${folder}/page.h\"

namespace brandung {
using namespace std::string_view_literals;

std::string_view ${function}() { return ${literals}sv; }

}  // namespace brandung
")
    file(COPY_FILE ${output}.new ${output} ONLY_IF_DIFFERENT)
    set(${variable} ${output} PARENT_SCOPE)
endfunction()
