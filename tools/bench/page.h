/// The page of `brandung bench growth`: tools/bench/page.html, built into the program; the data take the place of /*DATA*/null.
#pragma once
#include <string_view>

namespace brandung {

std::string_view growth_page_html();

}  // namespace brandung
