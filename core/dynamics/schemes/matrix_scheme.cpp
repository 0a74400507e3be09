#include "core/dynamics/schemes/matrix_scheme.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/schemes/axial_dampers.h"
#include "core/dynamics/schemes/fluid_answers.h"
#include "core/dynamics/schemes/implicit_system.h"
#include "core/dynamics/schemes/schemes.h"

#include <cmath>

namespace esm {

namespace {

constexpr int mostBranchRounds = 4; ///< after which all springs are taken for strained

constexpr double roundingShare = 1e-9; ///< of potentials; differences below it say nothing
constexpr int mostHalfWays = 4; ///< from a step that overshoots to the safe one: to a sixteenth of the way
constexpr double gainedShare = 1e-4; ///< of the energy that moves in a step; in 1000 steps a tenth

// Newton's steps with axial damping. To solve each of them more exactly gains nothing.
constexpr int mostNewtonSteps = 4;
constexpr double newtonTolerance = 1e-3; ///< of the velocities, in the mean square over masses
constexpr double solverTolerance = 1e-3; ///< of a step's equation
constexpr int mostNewtonHalvings = 9;    ///< of a step that would go uphill

double kineticEnergy(const SpringSystem& system, const Vectors& velocities) {
    double sum = 0;
    for (std::size_t i = 0; i < velocities.size(); ++i)
        sum += 0.5 * system.mass[i] * velocities[i].squaredNorm();
    return sum;
}

} // namespace

struct MatrixScheme::Start {
    const SpringSystem& system;
    const StepInput& input;
    const Motion& before;
};

/// The step's form, with the matrix that it solves for.
struct MatrixScheme::Form : StepForm {
    MatrixFactors factors;
};

MatrixScheme::Form MatrixScheme::formOf(const StepInput& input, const Motion& before, bool builds) const {
    const double h = input.duration;
    const Scheme& scheme = schemeOf(builds ? m_integrator : traitsOf(m_integrator).startsAs);
    return {scheme.form(h, before, builds ? &*m_previous : nullptr), scheme.factors(h)};
}

/// Gives the led nodes the velocities that take them where they are led.
void MatrixScheme::lead(const std::vector<PrescribedNode>& prescribed, const Form& form,
                        const Vectors& positions, Vectors& velocities) {
    for (const PrescribedNode& led : prescribed) {
        Eigen::Vector3d way = led.position - positions[led.node];
        if (!form.drift.empty()) way -= form.drift[led.node];
        velocities[led.node] = way / form.reach;
    }
}

void MatrixScheme::remember(Motion before) {
    if (!hasSecondOrderForm(m_integrator)) return;
    m_previous = std::move(before);
    m_previousForces.swap(m_forces);
    m_previousPressures.swap(m_pressures);
}

UntouchedStep MatrixScheme::step(const SpringSystem& system, const StepInput& input, const Motion& before,
                                 StepperSolvers& solvers) {
    const Start start{system, input, before};
    if (m_previous)
        if (auto built = solve(start, solvers.linear(system, input.duration, true), true)) {
            built->buildsOnLast = true;
            return std::move(*built);
        }
    return firstStep(start, solvers);
}

UntouchedStep MatrixScheme::firstStep(const Start& start, StepperSolvers& solvers) {
    const double duration = start.input.duration;
    if (hasConstantMatrix(m_integrator) && solvers.hasBranches(duration)) return branchStep(start, solvers);
    return *solve(start, solvers.linear(start.system, duration, false), false);
}

// Where a spring is up to its strain before and after, it is so in between, and the matrix resists it no less
// than its law does: only then is the step sure not to overshoot.
UntouchedStep MatrixScheme::branchStep(const Start& start, StepperSolvers& solvers) {
    for (int round = 0;; ++round) {
        UntouchedStep step = *solve(start, solvers.branch(start.system, start.input.duration), false);
        placePrescribedNodes(start.input, step.motion.positions);
        if (!solvers.strain(start.system, step.motion.positions)) return step;
        if (round == mostBranchRounds) solvers.strainAll();
    }
}

std::optional<UntouchedStep> MatrixScheme::solve(const Start& start, StepSolver& solver, bool builds) {
    const auto& [system, input, before] = start;
    const Form form = formOf(input, before, builds);
    innerForces(start, form, before.positions, m_forces);
    notePressures(start, form);
    UntouchedStep step{before, {}, false};
    lead(input.prescribed, form, before.positions, step.motion.velocities);
    if (hasConstantMatrix(m_integrator))
        solveConstant(start, form, solver, step);
    else if (m_damping == Damping::Axial)
        solveTurning(start, form, solver, step.motion.velocities);
    else if (!solveTangent(start, form, solver, step))
        return std::nullopt;
    step.motion.positions = placesAfter(start, form, step.motion.velocities);
    goBeyond(start, form, step.motion.velocities);
    return step;
}

/// Written as a change, so that what rests stays where it is to the last bit.
Vectors MatrixScheme::placesAfter(const Start& start, const Form& form, const Vectors& velocities) {
    Vectors places = start.before.positions;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] += form.reach * velocities[i];
        if (!form.drift.empty()) places[i] += form.drift[i];
    }
    return places;
}

/// From the velocities that the form solves for to those at the step's end. Led nodes keep theirs.
void MatrixScheme::goBeyond(const Start& start, const Form& form, Vectors& velocities) {
    if (form.beyond == 0) return;
    std::vector<char> isLed(velocities.size(), 0);
    for (const PrescribedNode& led : start.input.prescribed)
        isLed[led.node] = 1;
    for (std::size_t i = 0; i < velocities.size(); ++i)
        if (!isLed[i]) velocities[i] += form.beyond * (velocities[i] - start.before.velocities[i]);
}

/// N, of springs and tethers, and of fluids under loads: what turns and changes with the places.
void MatrixScheme::innerForces(const Start& start, const Form& form, const Vectors& places, Vectors& forces) {
    elasticForces(start.system, places, forces);
    addPressureOfLoads(start.system, *start.input.loads, form.endShare, places, forces);
}

/// Pa, at the step's beginning, where a later step may build on them.
void MatrixScheme::notePressures(const Start& start, const Form& form) {
    m_pressures = volumesOf(start.system, start.before.positions);
    for (std::size_t i = 0; i < m_pressures.size(); ++i) {
        const SpringSystem::Filled& cavity = start.system.cavities[i];
        m_pressures[i] =
            ownPressure(cavity, m_pressures[i]) + pressureOfLoads(*start.input.loads, cavity, form.endShare);
    }
}

// What extrapolation takes for the forces at the step's end must not foresee how a fluid's pressure changes:
// the matrix does that, and both together would count it twice. Of a fluid only the direction is
// extrapolated, p·(2g − g⁻), and what its volume changes by along the drift is taken from the pressure.
void MatrixScheme::foreseeDirectionsAlone(const Start& start, const Form& form, Vectors& extrapolated) const {
    for (std::size_t i = 0; i < m_pressures.size(); ++i) {
        const SpringSystem::Filled& cavity = start.system.cavities[i];
        const auto gradientAt = [&](const Vectors& positions) {
            return volumeOf(*cavity.wall, placesOf(*cavity.wall, positions)).gradient;
        };
        const Vectors now = gradientAt(start.before.positions), last = gradientAt(m_previous->positions);
        const double grown = scalarProduct(now, placesOf(*cavity.wall, form.drift));
        for (std::size_t place = 0; place < now.size(); ++place)
            extrapolated[cavity.wall->nodes[place]] +=
                (m_pressures[i] - m_previousPressures[i]) * last[place] +
                pressureSlope(cavity) * grown * now[place];
    }
}

// One solve is the whole step.
void MatrixScheme::solveConstant(const Start& start, const Form& form, StepSolver& solver,
                                 UntouchedStep& step) const {
    Vectors& velocities = step.motion.velocities;
    Vectors extrapolated;
    if (form.extrapolates) {
        extrapolated = m_previousForces;
        for (std::size_t i = 0; i < extrapolated.size(); ++i)
            extrapolated[i] -= m_forces[i];
        foreseeDirectionsAlone(start, form, extrapolated);
    }
    solveStep(solver, start.input.prescribed, fluidTerms(start, form), momentum(start, form, extrapolated),
              velocities, step.half);
}

/// Of the fluids' stiffness at the step's end.
GlobalTerms MatrixScheme::fluidTerms(const Start& start, const Form& form) {
    return globalTermsOf(start.system, start.before.positions,
                         start.input.duration * form.endShare * form.reach);
}

// One Newton step, and what is done where it is not good. The measure is the step's potential, which an exact
// step has the least of (Gast et al. 2015): where it rises, the step has gone too far. It does so where
// tissue lies in a plane and resists no force across it, or where springs become stiffer on the way.
//
// The constant matrix is nowhere below the tangent, so that its step never overshoots; but it is a small one.
// Half-way from the long step towards it, and half-way again, is often better. A form that is exact must not
// take such a mixture, which is of the first order. Nor has it to: it is held against the velocities there
// were, and where it is no better the step is refused and taken by the form that it starts as.
bool MatrixScheme::solveTangent(const Start& start, const Form& form, StepSolver& solver,
                                UntouchedStep& step) const {
    TangentMatrix tangent(start.system, m_damping, form.factors, start.before.positions);
    tangent.addLoads(*start.input.loads, form.endShare);
    if (!form.isExact) tangent.omitBuckling();
    Vectors stiffened = form.drift.empty() ? Vectors{} : tangent.stiffnessTimes(form.drift);
    for (Eigen::Vector3d& force : stiffened)
        force *= form.endShare;
    const Vectors asked = momentum(start, form, stiffened);

    Vectors& velocities = step.motion.velocities;
    Vectors safe = velocities, half;
    if (!form.isExact) solveStep(solver, start.input.prescribed, fluidTerms(start, form), asked, safe, half);
    solveImplicit(tangent, solver.matrix, start.input.prescribed, asked, velocities);
    const double known = potential(start, form, safe);
    const auto overshoots = [&] {
        const double reached = potential(start, form, velocities);
        return reached - known > roundingShare * (std::abs(reached) + std::abs(known));
    };
    if (!overshoots()) return !form.keepsEnergy || !gainsEnergy(start, form, tangent, velocities);
    if (form.isExact) return false;
    for (int halving = 0; halving < mostHalfWays; ++halving) {
        for (std::size_t i = 0; i < velocities.size(); ++i)
            velocities[i] = 0.5 * (velocities[i] + safe[i]);
        if (!overshoots()) return true;
    }
    velocities = std::move(safe);
    return true;
}

// The step solves with linearised forces, and what they do along its way h·w is what kinetic energy gains.
// The tissue is not linear: what its elastic energy loses on that way is something else, by the third order
// in h·w. Where it loses less than was gained, energy came from nowhere. That is harmless as far as viscosity
// takes it in the same step, or where it is next to nothing; a form that damps nothing would else gather it,
// in long steps without end.
bool MatrixScheme::gainsEnergy(const Start& start, const Form& form, const TangentMatrix& tangent,
                               const Vectors& velocities) const {
    const auto& [system, input, before] = start;
    const double h = input.duration;
    Vectors way = velocities, damping(velocities.size(), Eigen::Vector3d::Zero());
    for (Eigen::Vector3d& step : way)
        step *= h;
    const Vectors stiffened = tangent.stiffnessTimes(way);
    addDampingForces(system, m_damping, before.positions, velocities, damping);
    double work = 0, heat = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        work += way[i].dot(m_forces[i] - form.endShare * stiffened[i]);
        heat -= way[i].dot(damping[i]);
    }
    const double stored = innerEnergy(start, form, placesAfter(start, form, velocities)) -
                          innerEnergy(start, form, before.positions);
    const double moved = kineticEnergy(system, velocities) + std::abs(stored) + std::abs(work);
    return stored + work > heat + gainedShare * moved;
}

// The former length is that by the same formula by which the form takes its rates: over one step, or over
// two.
SpringSystem MatrixScheme::axiallyDamped(const Start& start, const Form& form) const {
    const auto& [system, input, before] = start;
    const LengthChange change =
        form.drift.empty() ? changeFrom(system, before.positions, input.duration)
                           : changeFrom(system, before.positions, m_previous->positions, input.duration);
    return withAxialDampers(system, change);
}

// Springs that damp along their axes alone turn within a step, and where they are viscous even a small turn
// matters: tissue that moved on along the old directions would stretch them, next to unresisted, by what the
// arc departs from its tangent. Newton's steps start from where the tissue is going, and each gains as much
// as the potential falls.
void MatrixScheme::solveTurning(const Start& start, const Form& form, StepSolver& solver,
                                Vectors& velocities) const {
    const SpringSystem damped = axiallyDamped(start, form);
    const Start turning{damped, start.input, start.before};
    for (int round = 0; round < mostNewtonSteps; ++round) {
        const Vectors places = placesAfter(start, form, velocities);
        TangentMatrix tangent(damped, Damping::Isotropic, form.factors, places);
        tangent.addLoads(*start.input.loads, form.endShare);
        tangent.omitBuckling();
        Vectors change(velocities.size(), Eigen::Vector3d::Zero());
        solveImplicit(tangent, solver.matrix, start.input.prescribed,
                      missing(turning, form, places, velocities), change, solverTolerance);
        const double share = takeDownhill(turning, form, change, velocities);
        const double changed = share * share * kineticEnergy(damped, change);
        if (changed <= newtonTolerance * newtonTolerance * kineticEnergy(damped, velocities)) return;
    }
}

/// Adds so large a share of a change that the potential does not rise; which share. The matrix is positive
/// definite, so that the change goes downhill at first, and some share will do. No more is asked than not to
/// rise: what is missing is left to the Newton steps that follow.
double MatrixScheme::takeDownhill(const Start& start, const Form& form, const Vectors& change,
                                  Vectors& velocities) const {
    const Vectors from = velocities;
    const double known = potential(start, form, from);
    for (int halving = 0; halving <= mostNewtonHalvings; ++halving) {
        const double share = std::ldexp(1, -halving);
        for (std::size_t i = 0; i < velocities.size(); ++i)
            velocities[i] = from[i] + share * change[i];
        const double reached = potential(start, form, velocities);
        if (reached - known <= roundingShare * (std::abs(reached) + std::abs(known))) return share;
    }
    velocities = from;
    return 0;
}

/// @param stiffened what is taken from the forces, N; empty: nothing
Vectors MatrixScheme::momentum(const Start& start, const Form& form, const Vectors& stiffened) const {
    const double h = start.input.duration;
    Vectors forces = m_forces;
    for (std::size_t i = 0; i < stiffened.size(); ++i)
        forces[i] -= stiffened[i];
    addExternalForces(start.system, *start.input.loads, forces);
    for (std::size_t i = 0; i < forces.size(); ++i)
        forces[i] = start.system.mass[i] * form.drive[i] + h * forces[i];
    return forces;
}

/// Makes of the elastic forces at the step's end, N, those that the form takes.
void MatrixScheme::addShareBefore(const Form& form, Vectors& forces) const {
    if (form.endShare == 1) return;
    for (std::size_t i = 0; i < forces.size(); ++i)
        forces[i] = form.endShare * forces[i] + (1 - form.endShare) * m_forces[i];
}

/// N·s, by which these velocities miss the step's equation.
Vectors MatrixScheme::missing(const Start& start, const Form& form, const Vectors& places,
                              const Vectors& velocities) const {
    Vectors forces;
    innerForces(start, form, places, forces);
    addShareBefore(form, forces);
    addExternalForces(start.system, *start.input.loads, forces);
    addDampingForces(start.system, m_damping, places, velocities, forces);
    for (std::size_t i = 0; i < forces.size(); ++i)
        forces[i] = start.system.mass[i] * (form.drive[i] - form.factors.mass * velocities[i]) +
                    start.input.duration * forces[i];
    return forces;
}

/// J, of which innerForces() are the fall.
double MatrixScheme::innerEnergy(const Start& start, const Form& form, const Vectors& places) {
    double result = energy(start.system, places, {}).elastic;
    if (start.input.loads->pressures.empty()) return result;
    const std::vector<double> volumes = volumesOf(start.system, places);
    for (std::size_t i = 0; i < volumes.size(); ++i)
        result -= pressureOfLoads(*start.input.loads, start.system.cavities[i], form.endShare) * volumes[i];
    return result;
}

/// J, what an exact step has the least of: the form above is where its gradient vanishes.
// Its gradient by w is M·(mass·w − drive) − h·(endShare·f(x⁺) + (1 − endShare)·f(x) − D·w + g). Forces at x⁺
// enter by their energy, whose gradient by w has the factor reach: hence h/reach. All that does not depend on
// x⁺ is linear in w, and viscosity is quadratic, so that it enters with half its force.
double MatrixScheme::potential(const Start& start, const Form& form, const Vectors& velocities) const {
    const double h = start.input.duration;
    Vectors damping(velocities.size(), Eigen::Vector3d::Zero()), external = damping;
    addDampingForces(start.system, m_damping, start.before.positions, velocities, damping);
    if (form.endShare < 1)
        for (std::size_t i = 0; i < external.size(); ++i)
            external[i] = (1 - form.endShare) * m_forces[i];
    addExternalForces(start.system, *start.input.loads, external);
    double result = 0;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        const Eigen::Vector3d& v = velocities[i];
        result += start.system.mass[i] * v.dot(0.5 * form.factors.mass * v - form.drive[i]) -
                  h * v.dot(external[i] + 0.5 * damping[i]);
    }
    return result +
           form.endShare * h / form.reach * innerEnergy(start, form, placesAfter(start, form, velocities));
}

} // namespace esm
