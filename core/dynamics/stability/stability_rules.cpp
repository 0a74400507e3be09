#include "core/dynamics/stability/stability_rules.h"

#include "core/dynamics/stability/definite_step.h"
#include "core/dynamics/stability/largest_eigenvalue.h"
#include "core/dynamics/stability/oscillator.h"
#include "core/dynamics/stability/rest_matrix.h"
#include "core/dynamics/step_matrix.h"

#include <cmath>
#include <functional>

namespace esm {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// The least of split2Limit(x)/x up to x = 8/7.
const double leastQuotient = 2.5 + std::sqrt(6.0);

/// Largest h ≥ `stable`, up to `cap`, for which `holds`, which is true below some step and false above it;
/// short of it by at most the tolerance, relative.
double largestHolding(double stable, double cap, double tolerance, const std::function<bool(double)>& holds) {
    if (stable >= cap || (std::isfinite(cap) && holds(cap))) return cap;
    // In uniform tissue the first guess is the limit itself.
    if (!holds((1 + tolerance) * stable)) return stable;
    double unstable = cap;
    for (int doubling = 0; doubling < 60 && 2 * stable < cap; ++doubling) {
        if (!holds(2 * stable)) {
            unstable = 2 * stable;
            break;
        }
        stable *= 2;
    }
    if (!std::isfinite(unstable)) return noStepLimit;
    while (unstable > (1 + tolerance) * stable) {
        const double middle = std::sqrt(stable * unstable);
        (holds(middle) ? stable : unstable) = middle;
    }
    return stable;
}

Matrix massNormalised(const Matrix& matrix, const Matrix& mass) {
    const Eigen::VectorXd scale = mass.diagonal().cwiseSqrt().cwiseInverse();
    return Matrix(scale.asDiagonal() * matrix * scale.asDiagonal());
}

/// Whether every oscillator with the given bounds, in units of the step, stays below the limit: no stiffer
/// than stepDamping/ratio, which is how little damping there is.
struct StepBounds {
    double stiffness, damping, ratio;
};

/// stiffnessLimit() at some dampings, increasing.
using LimitCurve = std::vector<std::pair<double, double>>;

LimitCurve limitCurve(Integrator integrator) {
    constexpr int points = 96;
    constexpr double least = 1e-9;
    const double most = decayLimit(integrator);
    LimitCurve curve{{0, stiffnessLimit(integrator, 0)}};
    for (int i = 0; i < points; ++i) {
        const double damping = least * std::pow(most / least, i / (points - 1.0));
        curve.emplace_back(damping, stiffnessLimit(integrator, 0.999999 * damping));
    }
    return curve;
}

/// Worked out once: they depend on nothing.
const LimitCurve& curveOf(Integrator integrator) {
    static const LimitCurve heun = limitCurve(Integrator::Heun), rk4 = limitCurve(Integrator::Rk4),
                            adamsMoulton = limitCurve(Integrator::AdamsMoulton);
    return integrator == Integrator::Heun ? heun : integrator == Integrator::Rk4 ? rk4 : adamsMoulton;
}

bool staysBelow(const LimitCurve& curve, const StepBounds& bounds) {
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

StabilityRules::StabilityRules(const SpringSystem& system, Damping damping, StabilitySearch search)
    : m_search(std::move(search)) {
    const bool isAtRest = m_search.deformation == Deformation::AtRest;
    const auto matrix = [&](const MatrixFactors& factors) {
        return isAtRest ? restMatrix(system, damping, factors)
                        : laplacianMatrix(system, factors, system.fixed);
    };
    m_mass = matrix({1, 0, 0});
    m_damping = matrix({0, 1, 0});
    m_stiffness = matrix({0, 0, 1});
    reportProgress(m_search.progress, 0);
    Eigenpair stiffest = largestEigenpair(massNormalised(m_stiffness, m_mass), m_search.tolerance / 2);
    m_largestStiffness = stiffest.value;
    if (stiffest.value > 0) m_stiffest = stiffest.vector.cwiseQuotient(m_mass.diagonal().cwiseSqrt());
    // Moved across their axes, springs that damp along them alone have no damping.
    m_ratio = isAtRest || damping == Damping::Isotropic ? leastDampingRatio(system) : 0;
}

std::optional<double> StabilityRules::largestStable(Integrator integrator, double cap) {
    switch (integrator) {
    case Integrator::Euler:
        return euler(cap);
    case Integrator::Verlet:
        return verlet(cap);
    case Integrator::Heun:
    case Integrator::Rk4:
    case Integrator::AdamsMoulton:
        return multistage(integrator, cap);
    case Integrator::Propagation:
        return propagation(cap);
    case Integrator::Split:
        return split(cap);
    case Integrator::Split2:
        return split2(cap);
    default:
        return cap;
    }
}

// Preconditioned with the Laplacian's matrix, M + h·D + h²·K has its eigenvalues between 1 and 1/c, where K
// may vanish for a motion that the Laplacian resists with k: c = 1 + h²·k/(1 + h·d), most at the largest k,
// where d is at least ratio·k. Conjugate gradients take some 12·√c iterations to their tolerance.
double StabilityRules::largestSolvable(double cap) const {
    constexpr double mostContrast = 5000;
    if (m_largestStiffness == 0) return cap;
    const double damped = 0.5 * mostContrast * m_ratio;
    return std::min(cap, damped + std::sqrt(damped * damped + mostContrast / m_largestStiffness));
}

double StabilityRules::largestAngularFrequency() const {
    return std::sqrt(m_largestStiffness);
}

// λmax(h²K + 2hD) < 4
double StabilityRules::euler(double cap) {
    const double d = largestDamping();
    const double sure = 4 / (d + std::sqrt(d * d + 4 * m_largestStiffness));
    return largestDefinite({4, -2, -1}, sure, cap);
}

// λmax(h²K + 4hD) < 4
double StabilityRules::verlet(double cap) {
    const double d = largestDamping();
    const double sure = 2 / (d + std::sqrt(d * d + m_largestStiffness));
    return largestDefinite({4, -4, -1}, sure, cap);
}

// Two sides: the growing oscillations, bounded by the largest stiffness and damping and their least ratio,
// and pure decay at the rate r of the limit, which happens where r²M − r·hD + h²K becomes singular.
std::optional<double> StabilityRules::multistage(Integrator integrator, double cap) {
    const double decay = decayLimit(integrator), d = largestDamping();
    const double decaying = d > 0 ? decay / d : noStepLimit;
    if (m_largestStiffness == 0) return std::min(cap, decaying);
    const LimitCurve& curve = curveOf(integrator);
    // Without damping heun and adams-moulton let every oscillation grow, however slowly.
    if (m_ratio == 0 && curve.front().second < 0.01) return std::nullopt;
    const auto holds = [&](double h) {
        return staysBelow(curve, {h * h * m_largestStiffness, std::min(h * d, decay), m_ratio / h});
    };
    double sure = std::min(1 / std::sqrt(m_largestStiffness), decaying);
    while (sure > 0 && !holds(sure))
        sure /= 2;
    if (!(sure > 0)) return std::nullopt;
    const double oscillating = largestHolding(sure, cap, m_search.tolerance / 4, holds);
    // Deformed, a motion may be damped and meet no stiffness at all.
    if (m_search.deformation == Deformation::Any) return std::min(oscillating, decaying);
    return largestDefinite({decay * decay, -decay, 1}, decaying, oscillating);
}

// Always stable; but forces settle the slower the more a node's springs outweigh its mass: h·D + h²·K <
// 100·M.
double StabilityRules::propagation(double cap) {
    constexpr double most = 100;
    const double d = largestDamping();
    return std::min(cap, 2 * most / (d + std::sqrt(d * d + 4 * most * m_largestStiffness)));
}

// λmax(h²K − 2hD) < 4; on the line d = ratio·k that is h² − 2h·ratio < 4/k.
double StabilityRules::split(double cap) {
    if (m_largestStiffness == 0) return cap;
    const double sure = m_ratio + std::sqrt(m_ratio * m_ratio + 4 / m_largestStiffness);
    return largestDefinite({4, 2, -1}, sure, cap);
}

// Motions with h·d ≥ 8/7 leave the unit circle at −1: for them a half plane is the rule. The others are
// stable up to h = leastQuotient·ratio, and are none where all of the tissue is damped that much.
std::optional<double> StabilityRules::split2(double cap) {
    if (m_largestStiffness == 0) return cap;
    if (m_ratio == 0) return std::nullopt;
    const double sure = split2OnLine(cap), forAll = std::max(sure, leastQuotient * m_ratio);
    const double halfPlane = largestDefinite({16.0 / 3, 4.0 / 3, -1}, sure, cap);
    if (halfPlane <= forAll || isDampedBeyond(8.0 / 7, sure, m_mass, m_damping)) return halfPlane;
    return forAll;
}

// On the line d = ratio·k up to the largest k: h/ratio must stay below split2Limit(x)/x for every
// x ≤ h·ratio·k. That quotient falls to 5/2 + √6 at x = 0.3866, rises a little and falls again, not below
// that before x = 8/7.
double StabilityRules::split2OnLine(double cap) const {
    const auto holds = [this](double h) {
        const double damping = h * m_ratio * m_largestStiffness;
        const double quotient = split2Limit(damping) / damping;
        return h / m_ratio < (damping < 0.3866 ? quotient : std::min(quotient, leastQuotient));
    };
    const double strong = 4.0 / 3 * m_ratio, weak = std::cbrt(2 * m_ratio / m_largestStiffness);
    return largestHolding(holds(weak) ? std::max(weak, strong) : strong, cap, 1e-3, holds);
}

double StabilityRules::largestDefinite(const MatrixFactors& factors, double sure, double cap) const {
    if (m_largestStiffness == 0) return std::min(sure, cap);
    const StepFamily family{m_mass, m_damping, m_stiffness, factors};
    return largestDefiniteStep(family, m_stiffest, {sure, cap, m_search.tolerance, m_search.progress});
}

double StabilityRules::largestDamping() {
    if (m_largestDamping) return *m_largestDamping;
    reportProgress(m_search.progress, 0);
    m_largestDamping = largestEigenvalue(massNormalised(m_damping, m_mass), m_search.tolerance / 2);
    return *m_largestDamping;
}

} // namespace esm
