/// Where a preview is shown: what --preview says.
#pragma once
#include <string>

namespace brandung {

struct PreviewTarget {
    enum Kind { tev, web } kind = web;
    std::string host = "127.0.0.1";
    int port = 0;  ///< a web server takes any free one for 0
};

/// Reads "tev", "tev:HOST:PORT", "web" or "web:PORT"; a host of IPv6 numbers may stand in brackets. Throws CLI::ValidationError.
PreviewTarget read_preview_target(const std::string &text);

}  // namespace brandung
