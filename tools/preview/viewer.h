/// PreviewViewer: somebody who watches a render. Nothing here blocks but flush() and the end of its life.
#pragma once
#include <optional>
#include <string>

#include "tools/preview/state.h"

namespace brandung {

class PreviewViewer {
public:
    virtual ~PreviewViewer() = default;
    /// Whether it could show a new picture now.
    virtual bool wants_picture() const = 0;
    virtual void show(const SharedState &state) = 0;
    /// Waits until what was shown last has arrived, some seconds at most. Nothing is shown after it.
    virtual void flush() {}
    /// Why it has gone away, told once.
    virtual std::optional<std::string> take_fault() { return std::nullopt; }
};

}  // namespace brandung
