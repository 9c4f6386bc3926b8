#include "scene/lights/aliases.h"

#include <numeric>

namespace brandung {

std::vector<Alias> make_aliases(std::span<const double> weights) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<double> share;
    std::vector<Alias> aliases;
    std::vector<uint> poor, rich;
    for (uint i = 0; i < weights.size(); ++i) {
        share.push_back(weights[i] / sum * double(weights.size()));
        (share[i] < 1 ? poor : rich).push_back(i);
        aliases.push_back({1, i});
    }
    while (!poor.empty() && !rich.empty()) {
        const uint low = poor.back(), high = rich.back();
        poor.pop_back();
        aliases[low] = {float(share[low]), high};
        share[high] -= 1 - share[low];
        if (share[high] < 1) rich.pop_back(), poor.push_back(high);
    }
    return aliases;
}

}  // namespace brandung
