#include "core/dynamics/schemes/stepper_solvers.h"

namespace esm {

namespace {

/// Above this, leading nodes through their responses to each other costs more than a factorisation without
/// them.
constexpr std::size_t mostLedByImpulses = 64;

} // namespace

StepperSolvers::StepperSolvers(const SpringSystem& system, Integrator integrator, StepSolvers free)
    : m_integrator(integrator), m_free(std::move(free)),
      m_led(system.fixed, std::make_shared<MatrixFactoriser>()), m_strained(system) {}

void StepperSolvers::takeOver(const StepperSolvers& former) {
    m_formerSeconds = former.m_formerSeconds;
    m_led.setFactoriser(former.m_led.factoriser());
    if (former.factoriser() == factoriser()) return;
    // The former one is this thread's, and knows the network's order of elimination.
    m_formerSeconds += factoriser()->seconds();
    m_free.setFactoriser(former.factoriser());
}

double StepperSolvers::factorisationSeconds() const {
    return m_formerSeconds + factoriser()->seconds() + m_led.factoriser()->seconds();
}

void StepperSolvers::prepare(const SpringSystem& system, const StepInput& input, const Vectors& positions) {
    prescribe(input.prescribed, system.fixed);
    if (hasBranches(input.duration) && m_strained.follow(system, positions)) forgetBranches();
}

// The matrices without the led nodes stay, for when they are let go.
void StepperSolvers::prescribe(const std::vector<PrescribedNode>& led, const std::vector<char>& fixed) {
    m_leadsMany = led.size() > mostLedByImpulses;
    if (!m_leadsMany) return;
    std::vector<char> given = fixed;
    for (const PrescribedNode& node : led)
        given[node.node] = 1;
    if (given == m_led.given()) return;
    m_led = StepSolvers(std::move(given), m_led.factoriser());
}

bool StepperSolvers::hasBranches(double duration) const {
    return m_strained.canChange() && stepFactors(m_integrator, duration, false).stiffness > 0;
}

StepSolver& StepperSolvers::linear(const SpringSystem& system, double duration, bool builds) {
    return solvers().linear(system, m_integrator, duration, builds);
}

StepSolver& StepperSolvers::branch(const SpringSystem& system, double duration) {
    return solvers().branch(system, m_strained, m_integrator, duration);
}

StepSolver& StepperSolvers::forImpulses(const SpringSystem& system, double duration) {
    return hasBranches(duration) ? branch(system, duration) : linear(system, duration, false);
}

bool StepperSolvers::strain(const SpringSystem& system, const Vectors& positions) {
    const bool changed = m_strained.add(system, positions);
    if (changed) forgetBranches();
    return changed;
}

void StepperSolvers::strainAll() {
    m_strained.addAll();
    forgetBranches();
}

void StepperSolvers::forgetBranches() {
    m_free.forgetBranches();
    m_led.forgetBranches();
}

} // namespace esm
