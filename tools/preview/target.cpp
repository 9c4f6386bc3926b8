#include "tools/preview/target.h"

#include <CLI/CLI.hpp>
#include <charconv>

namespace brandung {
namespace {

constexpr int port_of_tev = 14158, port_of_web = 8080, last_port = 65535;

/// The port that `digits` say, -1 if they say none.
int read_port(const std::string &digits) {
    int port = -1;
    const char *const end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, port);
    return error == std::errc() && rest == end && port <= last_port ? port : -1;
}

std::string without_brackets(const std::string &host) {
    return host.size() > 2 && host.front() == '[' && host.back() == ']' ? host.substr(1, host.size() - 2) : host;
}

}  // namespace

PreviewTarget read_preview_target(const std::string &text) {
    if (text == "tev") return {PreviewTarget::tev, "127.0.0.1", port_of_tev};
    if (text == "web") return {PreviewTarget::web, "127.0.0.1", port_of_web};
    const std::size_t colon = text.rfind(':');
    const int port = colon == std::string::npos ? -1 : read_port(text.substr(colon + 1));
    if (text.starts_with("web:") && colon == 3 && port >= 0) return {PreviewTarget::web, "127.0.0.1", port};
    if (text.starts_with("tev:") && colon > 4 && port > 0) return {PreviewTarget::tev, without_brackets(text.substr(4, colon - 4)), port};
    throw CLI::ValidationError("--preview", "expected tev, tev:HOST:PORT, web or web:PORT, got '" + text + "'");
}

}  // namespace brandung
