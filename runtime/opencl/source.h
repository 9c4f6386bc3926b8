/// Kernel sources: files with their includes expanded into one text.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace brandung {

/// Virtual files: path -> text. They hide files of the same path.
using Sources = std::map<std::string, std::string>;

/// The text of a kernel file with its includes expanded; #line keeps the real names in error messages. Files with #pragma once come once.
/// What generated files define is left out where nothing uses it: kernels that do not depend on a constant have one text, and are compiled once.
/// Other files are those under kernels/ embedded in the program, or those in the folder that the environment's KERNEL_DIR names.
/// Throws Error for a file that does not exist.
std::string expand_source(const std::string &path, const Sources &generated);

/// FNV-1a, 64 bits.
std::uint64_t hash_of_text(std::string_view text);
/// Of the texts of all kernel files there, where KERNEL_DIR says. A file that is missing there counts as empty.
std::uint64_t hash_of_kernels();

}  // namespace brandung
