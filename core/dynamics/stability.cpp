#include "core/dynamics/stability.h"

#include "core/dynamics/largest_eigenvalue.h"
#include "core/dynamics/step_matrix.h"
#include "core/support/errors.h"

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

namespace esm {

namespace {

constexpr double noLimit = std::numeric_limits<double>::infinity();
constexpr double safetyFactor = 0.9;

using Matrix = Eigen::SparseMatrix<double>;

/// Largest h ≥ `stable`, up to `cap`, for which `holds`, which is true below some step and false above it;
/// short of it by at most the tolerance, relative.
double largestStep(double stable, double cap, double tolerance, const std::function<bool(double)>& holds) {
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
    if (!std::isfinite(unstable)) return noLimit;
    while (unstable > (1 + tolerance) * stable) {
        const double middle = std::sqrt(stable * unstable);
        (holds(middle) ? stable : unstable) = middle;
    }
    return stable;
}

/// Smallest d/c of everything elastic that can move: d ≥ ratio·k then holds for every motion, since each
/// spring and tether gives its share of both. Infinite when nothing is elastic.
double leastDampingRatio(const SpringSystem& system) {
    double ratio = noLimit;
    for (const auto& spring : system.springs)
        if (spring.springConstant > 0 && !(system.fixed[spring.first] && system.fixed[spring.second]))
            ratio = std::min(ratio, spring.viscosity / spring.springConstant);
    for (const Tether& tether : system.tethers)
        if (tether.springConstant > 0 && !system.fixed[tether.node])
            ratio = std::min(ratio, tether.viscosity / tether.springConstant);
    return ratio;
}

Matrix massNormalised(const Matrix& matrix, const Matrix& mass) {
    const Eigen::VectorXd scale = mass.diagonal().cwiseSqrt().cwiseInverse();
    return Matrix(scale.asDiagonal() * matrix * scale.asDiagonal());
}

/// The stability rules of one model. Any growth factor of a step is a root of the one-oscillator polynomial
/// at some (k, d) of the joint numerical range of K and D (mass-normalised), so a rule that holds on the
/// whole range, or on a larger set, is safe even where K and D have no common eigenvectors.
class StabilityRules {
public:
    StabilityRules(const SpringSystem& system, StabilitySearch search)
        : m_search(std::move(search)), m_mass(laplacianMatrix(system, {1, 0, 0}, system.fixed)),
          m_damping(laplacianMatrix(system, {0, 1, 0}, system.fixed)),
          m_stiffness(laplacianMatrix(system, {0, 0, 1}, system.fixed)),
          m_largestStiffness(largestEigenvalue(massNormalised(m_stiffness, m_mass))),
          m_ratio(leastDampingRatio(system)) {
        if (m_mass.rows() > 0) m_solver.analyzePattern(m_mass + m_damping + m_stiffness);
    }

    std::optional<double> largestStable(Integrator integrator, double cap) {
        switch (integrator) {
        case Integrator::Euler:
            return euler(cap);
        case Integrator::Split2:
            return split2(cap);
        default:
            return split(cap);
        }
    }

private:
    // λmax(h²K + 2hD) < 4
    double euler(double cap) {
        const double damping = largestEigenvalue(massNormalised(m_damping, m_mass));
        const double safe = 4 / (damping + std::sqrt(damping * damping + 4 * m_largestStiffness));
        return largestStep(safe, cap, m_search.tolerance,
                           [this](double h) { return isDefinite(4, -2 * h, -h * h); });
    }

    // λmax(h²K − 2hD) < 4; on the line d = ratio·k that is h² − 2h·ratio < 4/k.
    double split(double cap) {
        if (m_largestStiffness == 0) return cap;
        const double safe = m_ratio + std::sqrt(m_ratio * m_ratio + 4 / m_largestStiffness);
        return largestStep(safe, cap, m_search.tolerance,
                           [this](double h) { return isDefinite(4, 2 * h, -h * h); });
    }

    std::optional<double> split2(double cap) {
        if (m_largestStiffness == 0) return cap;
        if (m_ratio == 0) return std::nullopt;
        const double safe = split2OnLine(cap);
        // Where every mode is damped enough to leave the unit circle at −1, that half plane alone is the
        // rule.
        if (safe >= cap || !isDefinite(-8.0 / 7, safe, 0)) return safe;
        return largestStep(safe, cap, m_search.tolerance,
                           [this](double h) { return isDefinite(16.0 / 3, 4.0 / 3 * h, -h * h); });
    }

    /// On the line d = ratio·k up to the largest k: h/ratio must stay below split2Limit(x)/x for every
    /// x ≤ h·ratio·k. That quotient falls to 5/2 + √6 at x = 0.3866, rises a little and falls again.
    double split2OnLine(double cap) const {
        const auto holds = [this](double h) {
            const double damping = h * m_ratio * m_largestStiffness;
            const double quotient = split2Limit(damping) / damping;
            return h / m_ratio < (damping < 0.3866 ? quotient : std::min(quotient, 2.5 + std::sqrt(6.0)));
        };
        const double strong = 4.0 / 3 * m_ratio, weak = std::cbrt(2 * m_ratio / m_largestStiffness);
        return largestStep(holds(weak) ? std::max(weak, strong) : strong, cap, 1e-3, holds);
    }

    /// Whether massFactor·M + dampingFactor·D + stiffnessFactor·K is positive definite.
    bool isDefinite(double massFactor, double dampingFactor, double stiffnessFactor) {
        if (m_mass.rows() == 0) return true;
        reportProgress(m_search.progress, 1 - 1 / (1 + 0.1 * m_factorisations++));
        m_solver.factorize(massFactor * m_mass + dampingFactor * m_damping + stiffnessFactor * m_stiffness);
        return m_solver.info() == Eigen::Success;
    }

    StabilitySearch m_search;
    int m_factorisations = 0;
    Matrix m_mass, m_damping, m_stiffness;
    double m_largestStiffness; ///< ω², mass-normalised
    double m_ratio;
    Eigen::SimplicialLLT<Matrix> m_solver;
};

Integrator integratorFor(StabilityRules& rules, Damping damping, double step) {
    if (damping == Damping::Axial) return Integrator::Euler;
    for (Integrator integrator : {Integrator::Split2, Integrator::Split, Integrator::Euler})
        if (rules.largestStable(integrator, step).value_or(0) >= step) return integrator;
    return Integrator::Split;
}

/// The second-order form is worth a shorter step than the first-order one, but not any; where viscosity is so
/// small that taking it implicitly gains nothing, the explicit step is as good and cheaper.
ChosenStep bestChoice(StabilityRules& rules, Damping damping, double cap) {
    if (damping == Damping::Axial) return {Integrator::Euler, *rules.largestStable(Integrator::Euler, cap)};
    const double split = *rules.largestStable(Integrator::Split, cap);
    // Steps after a jump are first-order ones.
    const double split2 = std::min(split, rules.largestStable(Integrator::Split2, cap).value_or(0));
    if (split2 >= 0.5 * split) return {Integrator::Split2, split2};
    const double explicitStep = *rules.largestStable(Integrator::Euler, cap);
    if (explicitStep >= 0.8 * split) return {Integrator::Euler, explicitStep};
    return {Integrator::Split, split};
}

[[noreturn]] void refuse(Integrator integrator, double step) {
    std::ostringstream message;
    message << "the longest stable step of " << integratorName(integrator) << " would be " << step
            << " s, too short to compute with: lower the spring constant or the viscosity, or raise the mass";
    throw InvalidModel(message.str());
}

} // namespace

double split2Limit(double stepDamping) {
    if (stepDamping >= 8.0 / 7) return 16.0 / 3 + 4.0 / 3 * stepDamping;
    // Roots e^{iθ}, u = 1 − cos θ: stepDamping = 2u²/(1+3u), limit = stepDamping·(1/u + 5/2 + 3u/2).
    const double u = (3 * stepDamping + std::sqrt(9 * stepDamping * stepDamping + 8 * stepDamping)) / 4;
    return u > 0 ? stepDamping * (1 / u + 2.5 + 1.5 * u) : 0;
}

std::optional<double> criticalStep(const TissueModel& model, Integrator integrator,
                                   const StabilitySearch& search) {
    return StabilityRules(makeSpringSystem(model), search).largestStable(integrator, noLimit);
}

CriticalSteps criticalSteps(const TissueModel& model) {
    StabilityRules rules(makeSpringSystem(model), {});
    return {rules.largestStable(Integrator::Euler, noLimit), rules.largestStable(Integrator::Split, noLimit),
            rules.largestStable(Integrator::Split2, noLimit)};
}

ChosenStep chooseStep(const TissueModel& model, const SimulationSettings& settings) {
    if (auto problems = validate(settings); !problems.empty()) throw InvalidModel(std::move(problems));
    const bool isAuto = settings.integrator == Integrator::Auto;
    if (settings.timeStep && !isAuto) return {settings.integrator, *settings.timeStep};
    StabilityRules rules(makeSpringSystem(model), {0.05, {}});
    if (settings.timeStep)
        return {integratorFor(rules, settings.damping, *settings.timeStep), *settings.timeStep};

    const double cap = longestStep / safetyFactor;
    ChosenStep chosen{settings.integrator, 0};
    if (isAuto)
        chosen = bestChoice(rules, settings.damping, cap);
    else if (const auto step = rules.largestStable(settings.integrator, cap))
        chosen.timeStep = *step;
    else
        throw InvalidModel(
            "split2 has no stable step where a spring or tether has no viscosity: choose split or "
            "auto, or give all of the tissue some viscosity");
    chosen.timeStep = std::min(longestStep, chosen.timeStep * safetyFactor);
    if (chosen.timeStep < shortestStep) refuse(chosen.integrator, chosen.timeStep);
    return chosen;
}

} // namespace esm
