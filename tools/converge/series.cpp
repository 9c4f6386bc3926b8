#include "tools/converge/series.h"

#include "scene/measures/measures.h"

namespace brandung {

const std::vector<std::string> &followed_measures() {
    static const std::vector<std::string> names = {"mse", "relmse", "mape", "flip"};
    return names;
}

Errors errors_of(const Picture &picture, const Picture &reference) {
    const Comparison comparison = compare(pair_pictures(picture, reference, DynamicRange::hdr), default_pixels_per_degree);
    Errors errors;
    for (const Measure &measure : measures())
        for (const std::string &name : followed_measures())
            if (name == measure.name) errors[name] = measure.value(comparison).value();
    return errors;
}

}  // namespace brandung
