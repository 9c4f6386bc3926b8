/// The folder in which PoCL keeps kernels that it has built, and without which it builds none.
#pragma once
#include <string>

namespace brandung {

/// "PoCL cannot write its kernel cache ..." where that is so, else empty. Meant for when PoCL has failed: it tries to write there, as PoCL does.
std::string kernel_cache_fault();

}  // namespace brandung
