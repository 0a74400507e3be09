#include "core/dynamics/explicit_scheme.h"

#include <utility>

namespace esm {

namespace {

template<class Real> void addTo(Real (&components)[4], const Eigen::Vector3d& change) {
    for (int axis = 0; axis < 3; ++axis)
        components[axis] += static_cast<Real>(change[axis]);
}

template<class Real> void set(Real (&components)[4], const Eigen::Vector3d& value) {
    for (int axis = 0; axis < 3; ++axis)
        components[axis] = static_cast<Real>(value[axis]);
}

} // namespace

template<class Real>
ExplicitScheme<Real>::ExplicitScheme(const SpringSystem& system, Integrator integrator,
                                     const KernelOptions& options)
    : m_kernel(system, options), m_integrator(integrator) {}

template<class Real> void ExplicitScheme<Real>::restart() {
    m_state.clear();
    m_rates.clear();
}

template<class Real>
void ExplicitScheme<Real>::steps(const StepInput& input, std::size_t count, const Motion& before,
                                 Motion& after) {
    load(input, before);
    for (std::size_t step = 0; step < count; ++step)
        m_spare = std::exchange(m_state, next(input));
    after.positions.resize(before.positions.size());
    after.velocities.resize(before.velocities.size());
    m_kernel.store(m_state, after.positions, after.velocities);
}

template<class Real> typename ExplicitScheme<Real>::State ExplicitScheme<Real>::next(const StepInput& input) {
    switch (m_integrator) {
    case Integrator::Verlet:
        return verlet(input);
    case Integrator::Heun:
        return heun(input);
    case Integrator::Rk4:
        return rungeKutta(input, rates(input, m_state));
    case Integrator::AdamsMoulton:
        return adamsMoulton(input);
    default:
        return euler(input);
    }
}

template<class Real> void ExplicitScheme<Real>::load(const StepInput& input, const Motion& before) {
    if (m_state.empty()) m_state = m_kernel.load(before.positions, before.velocities);
    for (const HeldNode& held : input.held)
        set(m_state[m_kernel.rowOf(held.node)].velocity,
            (held.position - before.positions[held.node]) / input.duration);
}

template<class Real>
typename ExplicitScheme<Real>::State ExplicitScheme<Real>::rates(const StepInput& input,
                                                                 const State& state) const {
    State result(state.size());
    m_kernel.rates(state, input.loads->gravity, result);
    for (const auto& [node, force] : input.loads->forces)
        addTo(result[m_kernel.rowOf(node)].velocity, double(m_kernel.inverseMass(node)) * force);
    for (const HeldNode& held : input.held)
        set(result[m_kernel.rowOf(held.node)].velocity, Eigen::Vector3d::Zero());
    return result;
}

/// start + Σ factor·rates
template<class Real>
typename ExplicitScheme<Real>::State ExplicitScheme<Real>::advanced(const State& start,
                                                                    std::initializer_list<Term> terms) {
    State result = start;
    for (const auto& [seconds, rates] : terms) {
        const auto factor = static_cast<Real>(seconds);
        for (std::size_t row = 0; row < result.size(); ++row)
            for (int axis = 0; axis < 4; ++axis) {
                result[row].position[axis] += factor * (*rates)[row].position[axis];
                result[row].velocity[axis] += factor * (*rates)[row].velocity[axis];
            }
    }
    return result;
}

template<class Real>
typename ExplicitScheme<Real>::State ExplicitScheme<Real>::euler(const StepInput& input) {
    const double h = input.duration;
    State next = std::move(m_spare);
    next.resize(m_state.size());
    m_kernel.step(m_state, next, h, input.loads->gravity);
    for (const auto& [node, force] : input.loads->forces) {
        const Eigen::Vector3d change = h * double(m_kernel.inverseMass(node)) * force;
        auto& record = next[m_kernel.rowOf(node)];
        addTo(record.velocity, change);
        addTo(record.position, h * change);
    }
    for (const HeldNode& held : input.held) {
        const std::size_t row = m_kernel.rowOf(held.node);
        set(next[row].position, held.position);
        std::copy_n(m_state[row].velocity, 4, next[row].velocity);
    }
    return next;
}

template<class Real>
typename ExplicitScheme<Real>::State ExplicitScheme<Real>::verlet(const StepInput& input) {
    const double h = input.duration;
    if (m_rates.empty()) m_rates.insert(m_rates.begin(), rates(input, m_state));
    const State& last = m_rates.front();
    // Both halves of the state moved by h·(v, a): the velocity is then the one that forces are asked at, and
    // the position lacks h²/2·a.
    State predicted = advanced(m_state, {{h, &last}});
    const auto half = static_cast<Real>(h * h / 2);
    for (std::size_t row = 0; row < predicted.size(); ++row)
        for (int axis = 0; axis < 3; ++axis)
            predicted[row].position[axis] += half * last[row].velocity[axis];
    State now = rates(input, predicted);
    State next = advanced(m_state, {{h / 2, &last}, {h / 2, &now}});
    for (std::size_t row = 0; row < next.size(); ++row)
        std::copy_n(predicted[row].position, 4, next[row].position);
    // The next step starts from this step's velocity, not from the predicted one.
    for (std::size_t row = 0; row < next.size(); ++row)
        std::copy_n(next[row].velocity, 4, now[row].position);
    m_rates.front() = std::move(now);
    return next;
}

template<class Real>
typename ExplicitScheme<Real>::State ExplicitScheme<Real>::heun(const StepInput& input) const {
    const double h = input.duration;
    const State first = rates(input, m_state), second = rates(input, advanced(m_state, {{h, &first}}));
    return advanced(m_state, {{h / 2, &first}, {h / 2, &second}});
}

template<class Real>
typename ExplicitScheme<Real>::State ExplicitScheme<Real>::rungeKutta(const StepInput& input,
                                                                      const State& first) const {
    const double h = input.duration;
    const State second = rates(input, advanced(m_state, {{h / 2, &first}})),
                third = rates(input, advanced(m_state, {{h / 2, &second}})),
                fourth = rates(input, advanced(m_state, {{h, &third}}));
    return advanced(m_state, {{h / 6, &first}, {h / 3, &second}, {h / 3, &third}, {h / 6, &fourth}});
}

template<class Real>
typename ExplicitScheme<Real>::State ExplicitScheme<Real>::adamsMoulton(const StepInput& input) {
    constexpr std::size_t needed = 4;
    m_rates.insert(m_rates.begin(), rates(input, m_state));
    if (m_rates.size() < needed) return rungeKutta(input, m_rates.front());
    const double part = input.duration / 24;
    const State &now = m_rates[0], &last = m_rates[1], &second = m_rates[2], &third = m_rates[3];
    const State predicted = rates(
        input, advanced(m_state,
                        {{55 * part, &now}, {-59 * part, &last}, {37 * part, &second}, {-9 * part, &third}}));
    State next =
        advanced(m_state, {{9 * part, &predicted}, {19 * part, &now}, {-5 * part, &last}, {part, &second}});
    m_rates.resize(needed - 1);
    return next;
}

template class ExplicitScheme<float>;
template class ExplicitScheme<double>;

} // namespace esm
