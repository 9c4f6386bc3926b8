#include "tools/bench/disagreement.h"

#include <algorithm>
#include <cmath>

#include "tools/bench/judge.h"

namespace brandung {
namespace {

constexpr std::uint64_t most_tests = 2'000'000'000;  ///< of rays and primitives by the judge: some ten seconds
constexpr std::uint64_t fewest_judged = 16;

Claim claim_of(const RayAnswers &answers, std::size_t i) {
    if (answers.hits.empty()) return {.meets = answers.visible[i] == 0};
    const Hit &hit = answers.hits[i];
    return {hit.primitive != NO_HIT, hit.primitive, answers.instances[i], hit.t};
}

bool differ(const Claim &a, const Claim &b) {
    if (a.meets != b.meets || !a.meets) return a.meets != b.meets;
    return a.primitive != b.primitive || a.instance != b.instance || std::abs(a.t - b.t) > 0x1p-12f * std::max(a.t, b.t);
}

/// That a ray may meet: those of a group once per instance.
std::uint64_t primitives_in(const SceneGeometry &geometry) {
    std::uint64_t count = 0;
    for (uint instance = 0; instance < std::max<std::size_t>(1, geometry.instances.size()); ++instance)
        count += geometry.space_of(instance).end - geometry.space_of(instance).first;
    return count;
}

}  // namespace

Disagreement compare_answers(const SceneGeometry &geometry, const RayQueue &queue, const RayAnswers &ours, const RayAnswers &theirs) {
    std::vector<Dispute> disputes;
    for (std::size_t i = 0; i < queue.count(); ++i) {
        const Claim our_claim = claim_of(ours, i), their_claim = claim_of(theirs, i);
        if (differ(our_claim, their_claim)) disputes.push_back({queue.rays[i], queue.shadow, our_claim, their_claim});
    }
    Disagreement all{.mismatches = disputes.size()};
    all.judged = std::min(all.mismatches, std::max(fewest_judged, most_tests / std::max<std::uint64_t>(1, primitives_in(geometry))));
    for (std::uint64_t k = 0; k < all.judged; ++k) disputes[k] = disputes[k * all.mismatches / all.judged];
    disputes.resize(all.judged);
    for (const Verdict &verdict : judge(geometry, disputes)) {
        all.ours_wrong += verdict.ours_wrong, all.theirs_wrong += verdict.theirs_wrong;
        all.ambiguous += !verdict.ours_wrong && !verdict.theirs_wrong;
    }
    return all;
}

}  // namespace brandung
