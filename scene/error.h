/// What is wrong with an input, in one line.
#pragma once
#include <stdexcept>

namespace brandung {

/// `place: what, with which thing, why`; the place is a file, with a line where there is one.
class SceneError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace brandung
