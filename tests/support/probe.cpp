#include "tests/support/probe.h"

#include <cstdlib>

namespace brandung {
namespace {

constexpr const char *file = "probe.cl";

Sources with_text(Sources sources, const std::string &text) {
    sources[file] = text;
    return sources;
}

}  // namespace

Device &test_device() {
    static Device device = Device::select("", 0, std::getenv("BRANDUNG_AS_GPU") != nullptr);
    return device;
}

Probe::Probe(const std::string &text, Sources generated) : kernel_(test_device(), file, "probe", with_text(std::move(generated), text), 1) {}

}  // namespace brandung
