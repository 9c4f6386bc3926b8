/// The page of `brandung converge`: tools/converge/page.html, built into the program; the data take the place of /*DATA*/null.
#pragma once
#include <string_view>

namespace brandung {

std::string_view converge_page_html();

}  // namespace brandung
