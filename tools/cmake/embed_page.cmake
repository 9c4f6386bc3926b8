# embed_page(FILE VARIABLE): writes a C++ file that defines page_html() (tools/preview/page.h) with FILE's text, and sets
# VARIABLE to its path.

function(embed_page file variable)
    text_literals(${file} literals)
    set(output ${PROJECT_BINARY_DIR}/generated/page.cpp)
    file(WRITE ${output}.new
"#include \"tools/preview/page.h\"

namespace brandung {
using namespace std::string_view_literals;

std::string_view page_html() { return ${literals}sv; }

}  // namespace brandung
")
    file(COPY_FILE ${output}.new ${output} ONLY_IF_DIFFERENT)
    set(${variable} ${output} PARENT_SCOPE)
endfunction()
