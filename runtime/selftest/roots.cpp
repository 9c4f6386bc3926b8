#include "runtime/selftest/roots.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

extended allowed_at(const Root &root) { return greater(root.error, 8 * ulp_of(root.t)); }

bool surely_within(const Root &root, float t_max) { return root.sure && root.t > root.side_error && root.t + root.error < t_max; }

std::string text_of(const Root &root) { return fmt::format("{:.9g} +- {:.2g}{}", double(root.t), double(root.error), root.sure ? "" : "?"); }

std::string text_of(const std::vector<Root> &roots) {
    std::string text;
    for (const Root &root : roots) text += (text.empty() ? "" : ", ") + text_of(root);
    return text.empty() ? "none" : text;
}

/// Rounding may decide whether the first root that counts does.
bool is_ambiguous(const std::vector<Root> &roots, float t_max) {
    const Root *first = nullptr;
    for (const Root &root : roots)
        if (root.t > -root.side_error && root.t - root.error <= t_max && (!first || root.t < first->t)) first = &root;
    return first && !surely_within(*first, t_max);
}

}  // namespace

bool has_sure_root(const std::vector<Root> &roots, float t_max) {
    return std::any_of(roots.begin(), roots.end(), [&](const Root &root) { return surely_within(root, t_max); });
}

Verdict judge(const std::vector<Root> &roots, Crossed crossed, float t_max) {
    Verdict verdict;
    verdict.ambiguous = is_ambiguous(roots, t_max);
    if (crossed.hit && !(crossed.t > 0 && crossed.t <= t_max)) {
        verdict.fault = fmt::format("t = {:.9g} is not in (0, {:.9g}]", crossed.t, t_max);
        return verdict;
    }
    bool known = !crossed.hit;
    for (const Root &root : roots) {
        const extended error = absolute(crossed.t - root.t), allowed = allowed_at(root);
        if (!crossed.hit || error > allowed || root.t < -root.side_error) continue;
        if (!known || error < absolute(crossed.t - verdict.nearest)) verdict.nearest = root.t, verdict.allowed = allowed;
        known = true;
    }
    if (!known) verdict.fault = fmt::format("made up t = {:.9g}; there are {}", crossed.t, text_of(roots));
    for (const Root &root : roots)
        if (known && surely_within(root, t_max) && (!crossed.hit || root.t + allowed_at(root) < crossed.t))
            verdict.fault = crossed.hit ? fmt::format("overlooked t = {} before {:.9g}", text_of(root), crossed.t)
                                        : fmt::format("overlooked t = {}", text_of(root));
    return verdict;
}

}  // namespace brandung
