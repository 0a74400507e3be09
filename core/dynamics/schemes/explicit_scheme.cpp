#include "core/dynamics/schemes/explicit_scheme.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace esm {

namespace {

/// Steps between two looks at what has come to rest. Where motion spreads is looked at every step.
constexpr std::size_t stepsBetweenReleases = 64;

/// In double precision no number of steps that can be waited for adds up to anything.
template<class Real> constexpr bool keepsRemainders = std::is_same_v<Real, float>;

template<class Real> void addTo(Real (&components)[4], const Eigen::Vector3d& change) {
    for (int axis = 0; axis < 3; ++axis)
        components[axis] += static_cast<Real>(change[axis]);
}

template<class Real> void set(Real (&components)[4], const Eigen::Vector3d& value) {
    for (int axis = 0; axis < 3; ++axis)
        components[axis] = static_cast<Real>(value[axis]);
}

/// Evaluations within a step that must be kept until its end; Adams-Moulton starts as Rk4.
std::size_t stageRatesOf(Integrator integrator) {
    switch (integrator) {
    case Integrator::Heun:
        return 2;
    case Integrator::Rk4:
    case Integrator::AdamsMoulton:
        return 4;
    default:
        return 0;
    }
}

/// Evaluations that outlive their step.
std::size_t keptRatesOf(Integrator integrator) {
    switch (integrator) {
    case Integrator::Verlet:
        return 2;
    case Integrator::AdamsMoulton:
        return 4;
    default:
        return 0;
    }
}

} // namespace

template<class Real>
ExplicitScheme<Real>::ExplicitScheme(const SpringSystem& system, Integrator integrator,
                                     const KernelOptions& options, double restTolerance)
    : m_kernel(system, options), m_integrator(integrator), m_restTolerance(restTolerance),
      m_active(system, m_kernel, restTolerance), m_stageRates(stageRatesOf(integrator)),
      m_rates(keptRatesOf(integrator)) {}

template<class Real>
ExplicitScheme<Real> ExplicitScheme<Real>::withParameters(const SpringSystem& system) const {
    ExplicitScheme other = *this;
    other.m_kernel.setParameters(system);
    other.m_active = ActiveSlices<Real>(system, other.m_kernel, m_restTolerance);
    other.restart();
    return other;
}

template<class Real> void ExplicitScheme<Real>::restart() {
    m_isLoaded = false;
}

template<class Real>
void ExplicitScheme<Real>::steps(const StepInput& input, std::size_t count, const Motion& before,
                                 Motion& after) {
    load(input, before);
    double fractions = 0;
    for (std::size_t i = 0; i < count; ++i) {
        step(input);
        std::swap(m_state, m_next);
        fractions += m_active.fraction();
        ++m_stepsSinceLoad;
        followMotion(input.duration);
    }
    m_activeFraction = count > 0 ? fractions / static_cast<double>(count) : m_activeFraction;
    m_kernel.store(m_state, after.positions, after.velocities);
}

template<class Real> void ExplicitScheme<Real>::step(const StepInput& input) {
    switch (m_integrator) {
    case Integrator::Verlet:
        return verlet(input);
    case Integrator::Heun:
        return heun(input);
    case Integrator::Rk4:
        computeRates(input, m_state, m_stageRates[0]);
        return rungeKutta(input, m_stageRates[0]);
    case Integrator::AdamsMoulton:
        return adamsMoulton(input);
    default:
        return euler(input);
    }
}

template<class Real> void ExplicitScheme<Real>::load(const StepInput& input, const Motion& before) {
    if (!m_isLoaded) {
        m_state = m_kernel.load(before.positions, before.velocities);
        for (State* buffer : {&m_next, &m_stage})
            buffer->resize(m_state.size());
        for (State& rates : m_stageRates)
            rates.resize(m_state.size());
        for (State& rates : m_rates)
            rates.resize(m_state.size());
        m_remainders.assign(keepsRemainders<Real> ? m_kernel.sliceCount() : 0, {});
        m_ratesKnown = 0;
        m_stepsSinceLoad = 0;
        m_active.activateAll();
        m_isLoaded = true;
    }
    for (const HeldNode& held : input.held)
        set(m_state[m_kernel.rowOf(held.node)].velocity,
            (held.position - before.positions[held.node]) / input.duration);
}

template<class Real> void ExplicitScheme<Real>::followMotion(double timeStep) {
    if (m_stepsSinceLoad % stepsBetweenReleases == 1)
        rest(m_active.release(m_next, m_state, timeStep));
    else
        m_active.follow(m_next, m_state, timeStep);
}

template<class Real> void ExplicitScheme<Real>::rest(const typename TissueKernel<Real>::SliceList& slices) {
    const auto forget = [](std::vector<State>& states, std::size_t row) {
        for (State& rates : states)
            rates[row] = {};
    };
    for (const std::size_t slice : slices)
        for (std::size_t row = slice * kernel::sliceHeight; row < (slice + 1) * kernel::sliceHeight; ++row) {
            std::fill_n(m_state[row].velocity, 4, Real{0});
            m_next[row] = m_stage[row] = m_state[row];
            forget(m_stageRates, row);
            forget(m_rates, row);
        }
}

template<class Real>
template<class Visit>
void ExplicitScheme<Real>::forActiveRows(const Visit& visit) const {
    if (m_active.areAll()) {
        for (std::size_t row = 0; row < m_state.size(); ++row)
            visit(row);
        return;
    }
    for (const std::size_t slice : m_active.list())
        for (std::size_t row = slice * kernel::sliceHeight; row < (slice + 1) * kernel::sliceHeight; ++row)
            visit(row);
}

template<class Real>
void ExplicitScheme<Real>::computeRates(const StepInput& input, const State& state, State& rates) {
    const Loads& loads = *input.loads;
    if (m_active.areAll())
        m_kernel.rates(state, loads.gravity, rates);
    else
        m_kernel.rates(state, loads.gravity, rates, m_active.list());
    for (const auto& [node, force] : loads.forces)
        if (m_active.contains(m_kernel.sliceOf(node)))
            addTo(rates[m_kernel.rowOf(node)].velocity, double(m_kernel.inverseMass(node)) * force);
    for (const HeldNode& held : input.held)
        set(rates[m_kernel.rowOf(held.node)].velocity, Eigen::Vector3d::Zero());
}

/// record += Σ factor·rates
template<class Real>
void ExplicitScheme<Real>::addRates(std::initializer_list<Term> terms, std::size_t row, Record& record) {
    for (const Term& term : terms) {
        const auto factor = static_cast<Real>(term.factor);
        const auto& rate = (*term.rates)[row];
        for (int axis = 0; axis < 4; ++axis) {
            record.position[axis] += factor * rate.position[axis];
            record.velocity[axis] += factor * rate.velocity[axis];
        }
    }
}

/// to = m_state + Σ factor·rates
template<class Real> void ExplicitScheme<Real>::advance(State& to, std::initializer_list<Term> terms) const {
    forActiveRows([&to, terms, this](std::size_t row) {
        Record record = m_state[row];
        addRates(terms, row, record);
        to[row] = record;
    });
}

template<class Real>
void ExplicitScheme<Real>::addKeeping(Real change, std::size_t row, int axis, Real& position) {
    if constexpr (!keepsRemainders<Real>) {
        position += change;
        return;
    }
    Real& remainder = m_remainders[row / kernel::sliceHeight].of[axis].of[row % kernel::sliceHeight];
    const Real whole = change + remainder, result = position + whole;
    remainder = whole - (result - position);
    position = result;
}

template<class Real> void ExplicitScheme<Real>::finish(std::initializer_list<Term> terms) {
    forActiveRows([terms, this](std::size_t row) {
        Record change{};
        addRates(terms, row, change);
        m_next[row] = m_state[row];
        for (int axis = 0; axis < 3; ++axis) {
            addKeeping(change.position[axis], row, axis, m_next[row].position[axis]);
            m_next[row].velocity[axis] += change.velocity[axis];
        }
    });
}

template<class Real>
const typename ExplicitScheme<Real>::State& ExplicitScheme<Real>::stage(std::initializer_list<Term> terms) {
    advance(m_stage, terms);
    return m_stage;
}

template<class Real> void ExplicitScheme<Real>::euler(const StepInput& input) {
    const double h = input.duration;
    const Loads& loads = *input.loads;
    const typename TissueKernel<Real>::Step step{h, loads.gravity,
                                                 keepsRemainders<Real> ? &m_remainders : nullptr};
    if (m_active.areAll())
        m_kernel.step(m_state, m_next, step);
    else
        m_kernel.step(m_state, m_next, step, m_active.list());
    for (const auto& [node, force] : loads.forces) {
        if (!m_active.contains(m_kernel.sliceOf(node))) continue;
        const Eigen::Vector3d change = h * double(m_kernel.inverseMass(node)) * force;
        const std::size_t row = m_kernel.rowOf(node);
        addTo(m_next[row].velocity, change);
        for (int axis = 0; axis < 3; ++axis)
            addKeeping(static_cast<Real>(h * change[axis]), row, axis, m_next[row].position[axis]);
    }
    for (const HeldNode& held : input.held) {
        const std::size_t row = m_kernel.rowOf(held.node);
        set(m_next[row].position, held.position);
        std::copy_n(m_state[row].velocity, 4, m_next[row].velocity);
    }
}

template<class Real> void ExplicitScheme<Real>::verlet(const StepInput& input) {
    const double h = input.duration;
    State &last = m_rates[0], &now = m_rates[1];
    if (m_ratesKnown == 0) computeRates(input, m_state, last);
    // Both halves of the state moved by h·(v, a): the velocity is then the one that forces are asked at, and
    // the position lacks h²/2·a.
    advance(m_stage, {{h, &last}});
    const auto whole = static_cast<Real>(h), half = static_cast<Real>(h * h / 2);
    forActiveRows([&](std::size_t row) {
        for (int axis = 0; axis < 3; ++axis) {
            m_stage[row].position[axis] = m_state[row].position[axis];
            addKeeping(whole * last[row].position[axis] + half * last[row].velocity[axis], row, axis,
                       m_stage[row].position[axis]);
        }
    });
    computeRates(input, m_stage, now);
    advance(m_next, {{h / 2, &last}, {h / 2, &now}});
    forActiveRows([&](std::size_t row) {
        std::copy_n(m_stage[row].position, 4, m_next[row].position);
        // The next step starts from this step's velocity, not from the predicted one.
        std::copy_n(m_next[row].velocity, 4, now[row].position);
    });
    std::swap(last, now);
    m_ratesKnown = 1;
}

template<class Real> void ExplicitScheme<Real>::heun(const StepInput& input) {
    const double h = input.duration;
    State &first = m_stageRates[0], &second = m_stageRates[1];
    computeRates(input, m_state, first);
    computeRates(input, stage({{h, &first}}), second);
    finish({{h / 2, &first}, {h / 2, &second}});
}

template<class Real> void ExplicitScheme<Real>::rungeKutta(const StepInput& input, const State& first) {
    const double h = input.duration;
    State &second = m_stageRates[1], &third = m_stageRates[2], &fourth = m_stageRates[3];
    computeRates(input, stage({{h / 2, &first}}), second);
    computeRates(input, stage({{h / 2, &second}}), third);
    computeRates(input, stage({{h, &third}}), fourth);
    finish({{h / 6, &first}, {h / 3, &second}, {h / 3, &third}, {h / 6, &fourth}});
}

template<class Real> void ExplicitScheme<Real>::adamsMoulton(const StepInput& input) {
    std::rotate(m_rates.begin(), m_rates.end() - 1, m_rates.end());
    computeRates(input, m_state, m_rates[0]);
    m_ratesKnown = std::min(m_ratesKnown + 1, m_rates.size());
    if (m_ratesKnown < m_rates.size()) return rungeKutta(input, m_rates[0]);
    const double part = input.duration / 24;
    const State &now = m_rates[0], &last = m_rates[1], &second = m_rates[2], &third = m_rates[3];
    State& predicted = m_stageRates[0];
    computeRates(input,
                 stage({{55 * part, &now}, {-59 * part, &last}, {37 * part, &second}, {-9 * part, &third}}),
                 predicted);
    finish({{9 * part, &predicted}, {19 * part, &now}, {-5 * part, &last}, {part, &second}});
}

template class ExplicitScheme<float>;
template class ExplicitScheme<double>;

} // namespace esm
