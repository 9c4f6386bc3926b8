/// Kernel sources: files with their includes expanded into one text.
#pragma once
#include <map>
#include <string>

namespace brandung {

/// Virtual files: path -> text. They hide files of the same path.
using Sources = std::map<std::string, std::string>;

/// The text of a kernel file with its includes expanded; #line keeps the real names in error messages. Files with #pragma once come once.
/// Other files are those under kernels/ embedded in the program, or those in the folder that the environment's KERNEL_DIR names.
/// Throws Error for a file that does not exist.
std::string expand_source(const std::string &path, const Sources &generated);

}  // namespace brandung
