#include "scene/measures/measures.h"

#include "scene/measures/ssim.h"

namespace brandung {

Comparison compare(const PicturePair &pair, double pixels_per_degree) {
    return {pixel_errors(pair), ssim(pair), flip(pair, pixels_per_degree), pair.not_finite()};
}

const std::vector<Measure> &measures() {
    using Value = std::optional<double>;
    static const std::vector<Measure> all = {
        {"mse", "mean of (a - b)^2", false, [](const Comparison &c) -> Value { return c.pixels.mse; }},
        {"relmse", "mean of (a - b)^2 / (b^2 + 0.01)", false, [](const Comparison &c) -> Value { return c.pixels.relmse; }},
        {"mape", "mean of |a - b| / (|b| + 0.01)", false, [](const Comparison &c) -> Value { return c.pixels.mape; }},
        {"psnr", "10 log10(peak^2 / mse) [dB]", true, [](const Comparison &c) -> Value { return c.pixels.psnr; }},
        {"ssim", "mean likeness of structure, at most 1", true, [](const Comparison &c) { return c.ssim; }},
        {"flip", "mean difference that is seen, 0 to 1", false, [](const Comparison &c) -> Value { return c.flip.mean; }},
        {"max_error", "greatest |a - b|", false, [](const Comparison &c) -> Value { return c.pixels.max_error.error; }},
        {"worst_block", "greatest relmse of 16 x 16 pixels", false, [](const Comparison &c) -> Value { return c.pixels.worst_block.relmse; }},
        {"not_finite", "pixels that are NaN or infinite, left out", false, [](const Comparison &c) -> Value { return double(c.not_finite); }},
    };
    return all;
}

}  // namespace brandung
