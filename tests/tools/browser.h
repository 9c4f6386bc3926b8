/// Pages in a real browser, where one is installed.
#pragma once
#include <string>

bool has_browser();
/// The page as it is after so many milliseconds by its own clock, which stands still while it loads something. `profile`: a folder for the browser.
std::string page_after(const std::string &url, int milliseconds, const std::string &profile);
/// Of the element of that name, up to its first child.
std::string text_of(const std::string &page, const std::string &id);
