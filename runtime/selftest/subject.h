/// Subject: one device function, or some that belong together, under test.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/opencl/device.h"
#include "runtime/selftest/findings.h"

namespace brandung {

class Subject {
public:
    virtual ~Subject() = default;
    /// Looks at one round of inputs; the same round has the same inputs.
    virtual Findings examine(uint round) = 0;
};

/// An entry of the list.
struct SubjectEntry {
    std::string name;
    std::string file;                                        ///< of the kernels that it tries, under kernels/
    std::string bound;                                       ///< what errors are held to, in words
    uint rounds = 1;                                         ///< unless more are asked for
    std::function<std::unique_ptr<Subject>(Device &)> make;  ///< builds its kernels; throws Error
};

/// All of them, in the order in which they run. Those of primitives are one per kind.
const std::vector<SubjectEntry> &subjects();

}  // namespace brandung
