/// What a camera needs so that its view is defined.
#pragma once
#include <optional>
#include <string>

#include "scene/scene.h"

namespace brandung {

/// The key of a camera that is at fault, and why.
struct ViewFault {
    const char *key;
    std::string why;
};

/// Views have a direction, which leaves open no more than a millionth which way is up; nothing if this one does.
std::optional<ViewFault> view_fault(const CameraDescription &camera);

}  // namespace brandung
