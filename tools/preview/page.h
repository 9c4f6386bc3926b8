/// The web page of a preview: tools/preview/page.html, built into the program.
#pragma once
#include <string_view>

namespace brandung {

std::string_view page_html();

}  // namespace brandung
