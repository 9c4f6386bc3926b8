#include "runtime/selftest/findings.h"

#include <algorithm>
#include <cmath>

namespace brandung {

void Errors::add(double error, double allowed, double ulp, double magnitude) {
    const auto raise = [](double &greatest, double x) { greatest = std::isnan(x) ? HUGE_VAL : std::max(greatest, x); };
    ++count;
    if (!(error <= allowed)) ++beyond;
    raise(max_of_bound, error == 0 ? 0 : error / allowed);
    if (!(allowed <= 0x1p-12 * magnitude)) return;
    ++well_conditioned;
    const double relative = error == 0 ? 0 : error / magnitude;
    raise(max_ulps, error / ulp), raise(max_relative, relative);
    sum_ulps += error / ulp, sum_relative += relative;
}

void Errors::add(const Errors &more) {
    count += more.count, beyond += more.beyond, unknown += more.unknown, well_conditioned += more.well_conditioned;
    sum_ulps += more.sum_ulps, sum_relative += more.sum_relative;
    max_ulps = std::max(max_ulps, more.max_ulps), max_relative = std::max(max_relative, more.max_relative);
    max_of_bound = std::max(max_of_bound, more.max_of_bound);
}

bool Findings::passed() const {
    return wrong == 0 && std::all_of(errors.begin(), errors.end(), [](const Errors &e) { return e.beyond == 0; });
}

void Findings::add(const Findings &more) {
    inputs += more.inputs, hits += more.hits, ambiguous += more.ambiguous, wrong += more.wrong;
    for (std::size_t i = 0; i < quantities; ++i) errors[i].add(more.errors[i]), rounding[i].add(more.rounding[i]);
    if (fault.empty()) fault = more.fault;
}

}  // namespace brandung
