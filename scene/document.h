/// Document: a JSON text with the place of each of its values.
#pragma once
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "scene/input.h"

namespace brandung {

struct Document {
    std::string file;
    std::string text;  ///< as read; an error finds its line here
    nlohmann::json root;
    std::set<std::string> assigned;  ///< JSON pointers ("/objects/3/radius") of what set_value has changed
    ReadProgress progress = {};      ///< of files that it names
};

/// Throws SceneError `file:line: ...` on bad syntax, duplicate keys, nesting beyond 64 levels or a file that cannot be read.
Document read_document(const std::string &file);
Document parse_document(std::string file, std::string text);

/// Sets the value at a dotted path ("integrator.threshold=0.1", "lights.0.intensity=[1,1,1]"); what is not JSON is taken as a string, and objects on
/// the way are made. Throws SceneError if the path leads through something that is neither object nor array, or beyond an array's end.
void set_value(Document &document, const std::string &assignment);

/// A key as one step of a JSON pointer.
std::string pointer_step(const std::string &key);

/// `file:line: pointer`, where the line is that of the innermost value on the way to `pointer` that the file has; `file: pointer (set on the command
/// line)` if the value came from set_value. Without the pointer if it is empty.
std::string place_of(const Document &document, const std::string &pointer);

/// Throws SceneError `place: why`, in one line.
[[noreturn]] void fail_at(const Document &document, const std::string &pointer, const std::string &why);

}  // namespace brandung
