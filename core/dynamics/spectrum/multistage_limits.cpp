#include "core/dynamics/spectrum/multistage_limits.h"

#include "core/dynamics/spectrum/largest_holding.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Whether every oscillator with the given bounds, in units of the step, stays below the limit: no stiffer
/// than stepDamping/ratio, which is how little damping there is.
struct StepBounds {
    double stiffness, damping, ratio;
};

// For each damping up to the bound's, the stiffest oscillator that the tissue may have is held against the
// curve. It is asked at the curve's points and at the bound itself, between which the curve is taken as
// straight.
bool staysBelow(const std::vector<std::pair<double, double>>& curve, const StepBounds& bounds) {
    const auto stiffest = [&](double damping) {
        return bounds.ratio > 0 ? std::min(bounds.stiffness, damping / bounds.ratio) : bounds.stiffness;
    };
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const auto& [damping, limit] = curve[i];
        const double here = stiffest(damping);
        if (here > 0 && !(here < limit)) return false;
        const auto& [nextDamping, nextLimit] = curve[i + 1];
        if (bounds.damping > nextDamping) continue;
        const double part = (bounds.damping - damping) / (nextDamping - damping);
        return stiffest(bounds.damping) < limit + part * (nextLimit - limit);
    }
    return stiffest(curve.back().first) < curve.back().second;
}

} // namespace

// Points over all orders of magnitude, each a quarter above the last: near no damping the limit may fall to
// nothing, as that of Heun's form does. Each limit is taken at a damping a little below its own: at the last
// point decay is about to leave the stable region, and rounding could say that it has.
MultistageLimits multistageLimits(Growth growth) {
    constexpr int points = 96;
    constexpr double least = 1e-9;
    const double most = decayLimit(growth);
    MultistageLimits limits{most, {{0, stiffnessLimit(growth, 0)}}};
    for (int i = 0; i < points; ++i) {
        const double damping = least * std::pow(most / least, i / (points - 1.0));
        limits.stiffness.emplace_back(damping, stiffnessLimit(growth, 0.999999 * damping));
    }
    return limits;
}

// Two sides: the growing oscillations, bounded by the largest stiffness and damping and their least ratio,
// and pure decay at the rate r of the limit, which happens where r²M − r·hD + h²K becomes singular.
std::optional<double> largestStableStep(const MultistageLimits& limits, TissueSpectrum& tissue, double cap) {
    const double decay = limits.decay, d = tissue.largestDamping(), k = tissue.largestStiffness();
    const double ratio = tissue.dampingRatio();
    const double decaying = d > 0 ? decay / d : noStepLimit;
    if (k == 0) return std::min(cap, decaying);
    // Without damping heun and adams-moulton let every oscillation grow, however slowly.
    if (ratio == 0 && limits.stiffness.front().second < 0.01) return std::nullopt;
    const auto holds = [&](double h) {
        return staysBelow(limits.stiffness, {h * h * k, std::min(h * d, decay), ratio / h});
    };
    double sure = std::min(1 / std::sqrt(k), decaying);
    while (sure > 0 && !holds(sure))
        sure /= 2;
    if (!(sure > 0)) return std::nullopt;
    const double oscillating = largestHolding(sure, cap, tissue.tolerance() / 4, holds);
    // Deformed, a motion may be damped and meet no stiffness at all.
    if (tissue.deformation() == Deformation::Any) return std::min(oscillating, decaying);
    return tissue.largestDefinite({decay * decay, -decay, 1}, decaying, oscillating);
}

} // namespace esm
