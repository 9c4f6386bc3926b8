/// Tables of aliases: choices among n by any weights, in a time that does not depend on n.
#pragma once
#include <span>
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// Entry i of n stands for itself with probability `kept` and for its alias otherwise.
struct Alias {
    float kept;
    uint alias;
};

/// All entries together choose each one by its weight, if each entry is as likely as any other: those with more than 1/n of the sum give what those
/// with less lack (Vose, IEEE Trans. Software Eng. 17(9) 1991). Weights are not negative and their sum is above 0.
std::vector<Alias> make_aliases(std::span<const double> weights);

}  // namespace brandung
