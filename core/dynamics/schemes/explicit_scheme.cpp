#include "core/dynamics/schemes/explicit_scheme.h"

#include "core/dynamics/schemes/schemes.h"

#include <algorithm>
#include <utility>

namespace esm {

namespace {

/// Steps between two looks at what has come to rest, so many that a look costs next to nothing beside them. A
/// late look costs time only. Where motion spreads is looked at every step: there a late look would be wrong.
constexpr std::size_t stepsBetweenReleases = 64;

template<class Real> auto stepOf(const ExplicitMethod& method) {
    if constexpr (std::is_same_v<Real, float>)
        return method.stepInFloat;
    else
        return method.stepInDouble;
}

/// m. Whatever moves a fluid's wall moves all of it at once, so that none of it may rest.
double toleratedRest(const SpringSystem& system, double restTolerance) {
    return system.cavities.empty() ? restTolerance : 0;
}

template<class Real>
ExplicitWork<Real> workFor(const SpringSystem& system, Integrator integrator, const KernelOptions& options,
                           double restTolerance) {
    TissueKernel<Real> tissueKernel(system, options);
    ActiveSlices<Real> active(system, tissueKernel, toleratedRest(system, restTolerance));
    const ExplicitMethod& method = schemeOf(integrator).explicitMethod;
    FluidForces<Real> fluids(system, tissueKernel, options.team);
    ExplicitWork<Real> work{
        .kernel = std::move(tissueKernel), .active = std::move(active), .fluids = std::move(fluids)};
    work.stageRates.resize(method.stageRates);
    work.keptRates.resize(method.keptRates);
    return work;
}

} // namespace

template<class Real>
ExplicitScheme<Real>::ExplicitScheme(const SpringSystem& system, Integrator integrator,
                                     const KernelOptions& options, double restTolerance)
    : m_step(stepOf<Real>(schemeOf(integrator).explicitMethod)), m_restTolerance(restTolerance),
      m_work(workFor<Real>(system, integrator, options, restTolerance)) {}

template<class Real>
std::unique_ptr<StepScheme> ExplicitScheme<Real>::withParameters(const SpringSystem& system) const {
    auto other = std::make_unique<ExplicitScheme>(*this);
    other->m_work.kernel.setParameters(system);
    other->m_work.active =
        ActiveSlices<Real>(system, other->m_work.kernel, toleratedRest(system, m_restTolerance));
    other->m_work.fluids.setParameters(system, other->m_work.kernel);
    other->restart();
    return other;
}

template<class Real> void ExplicitScheme<Real>::restart() {
    m_isLoaded = false;
}

template<class Real>
UntouchedStep ExplicitScheme<Real>::step(const SpringSystem& /*system*/, const StepInput& input,
                                         const Motion& before, StepperSolvers& /*solvers*/) {
    UntouchedStep step;
    run(input, 1, before, step.motion);
    return step;
}

template<class Real>
void ExplicitScheme<Real>::steps(const SpringSystem& /*system*/, const StepInput& input, std::size_t count,
                                 Motion& motion, StepperSolvers& /*solvers*/) {
    run(input, count, motion, motion);
}

template<class Real>
void ExplicitScheme<Real>::run(const StepInput& input, std::size_t count, const Motion& before,
                               Motion& after) {
    load(input, before);
    double fractions = 0;
    for (std::size_t i = 0; i < count; ++i) {
        m_step(m_work, input);
        std::swap(m_work.state, m_work.next);
        fractions += m_work.active.fraction();
        ++m_stepsSinceLoad;
        followMotion(input.duration);
    }
    m_activeFraction = count > 0 ? fractions / static_cast<double>(count) : m_activeFraction;
    m_work.kernel.store(m_work.state, after.positions, after.velocities);
}

template<class Real> void ExplicitScheme<Real>::load(const StepInput& input, const Motion& before) {
    if (!m_isLoaded) {
        m_work.state = m_work.kernel.load(before.positions, before.velocities);
        for (State* buffer : {&m_work.next, &m_work.between})
            buffer->resize(m_work.state.size());
        for (State& rates : m_work.stageRates)
            rates.resize(m_work.state.size());
        for (State& rates : m_work.keptRates)
            rates.resize(m_work.state.size());
        m_work.remainders.assign(keepsRemainders<Real> ? m_work.kernel.sliceCount() : 0, {});
        m_work.ratesKnown = 0;
        m_stepsSinceLoad = 0;
        m_work.active.activateAll();
        m_isLoaded = true;
    }
    for (const PrescribedNode& led : input.prescribed)
        setComponents(m_work.state[m_work.kernel.rowOf(led.node)].velocity,
                      (led.position - before.positions[led.node]) / input.duration);
}

template<class Real> void ExplicitScheme<Real>::followMotion(double timeStep) {
    if (m_stepsSinceLoad % stepsBetweenReleases == 1)
        rest(m_work.active.release(m_work.next, m_work.state, timeStep));
    else
        m_work.active.follow(m_work.next, m_work.state, timeStep);
}

// What rests is no longer written by any step, while the buffers of a step change places. All of them must
// therefore hold the same state for it, or it would jump to an old place with every other step; and rates
// that are kept must be none, or a form over several steps would move it on.
template<class Real> void ExplicitScheme<Real>::rest(const typename TissueKernel<Real>::SliceList& slices) {
    const auto forget = [](std::vector<State>& states, std::size_t row) {
        for (State& rates : states)
            rates[row] = {};
    };
    for (const std::size_t slice : slices)
        for (std::size_t row = slice * kernel::sliceHeight; row < (slice + 1) * kernel::sliceHeight; ++row) {
            std::fill_n(m_work.state[row].velocity, 4, Real{0});
            m_work.next[row] = m_work.between[row] = m_work.state[row];
            forget(m_work.stageRates, row);
            forget(m_work.keptRates, row);
        }
}

template class ExplicitScheme<float>;
template class ExplicitScheme<double>;

} // namespace esm
