#include "tools/bench/disagreement.h"

#include <algorithm>
#include <cmath>

namespace brandung {
namespace {

constexpr std::size_t judged_of = 16;         ///< of so many rays one is judged whatever is said
constexpr std::size_t judged_at_once = 8192;  ///< some tenths of a second

Claim claim_of(const RayAnswers &answers, std::size_t i) {
    if (answers.hits.empty()) return {.meets = answers.visible[i] == 0};
    const Hit &hit = answers.hits[i];
    return {hit.primitive != NO_HIT, hit.primitive, answers.instances[i], hit.t};
}

/// By more than so much of t, or in what is met.
bool differ(const Claim &a, const Claim &b, float part) {
    if (a.meets != b.meets || !a.meets) return a.meets != b.meets;
    return a.primitive != b.primitive || a.instance != b.instance || std::abs(a.t - b.t) > part * std::max(a.t, b.t);
}

}  // namespace

std::optional<Disagreement> compare_answers(const Judge &judge, const RayQueue &queue, const RayAnswers &ours, const RayAnswers &theirs,
                                            const std::function<bool()> &goes_on) {
    std::vector<Dispute> disputes;
    std::vector<bool> is_mismatch;
    for (std::size_t i = 0; i < queue.count(); ++i) {
        const Claim our_claim = claim_of(ours, i), their_claim = claim_of(theirs, i);
        if (!differ(our_claim, their_claim, 0x1p-20f) && i % judged_of != 0) continue;
        disputes.push_back({queue.rays[i], queue.shadow, our_claim, their_claim});
        is_mismatch.push_back(differ(our_claim, their_claim, 0x1p-12f));
    }
    Disagreement all{.judged = disputes.size()};
    for (std::size_t first = 0; first < disputes.size(); first += judged_at_once) {
        if (!goes_on()) return {};
        const std::size_t count = std::min(judged_at_once, disputes.size() - first);
        const std::vector<DisputeVerdict> verdicts = judge.judge(std::span(disputes).subspan(first, count));
        for (std::size_t i = 0; i < count; ++i) {
            const auto [ours_wrong, theirs_wrong] = verdicts[i];
            all.mismatches += is_mismatch[first + i];
            all.ours_wrong += ours_wrong, all.theirs_wrong += theirs_wrong;
            all.ambiguous += is_mismatch[first + i] && !ours_wrong && !theirs_wrong;
        }
    }
    return all;
}

}  // namespace brandung
