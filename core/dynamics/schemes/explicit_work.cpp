#include "core/dynamics/schemes/explicit_work.h"

namespace esm {

namespace {

/// record += Σ factor·rates
template<class Real>
void addRates(std::initializer_list<typename ExplicitWork<Real>::Term> terms, std::size_t row,
              typename ExplicitWork<Real>::Record& record) {
    for (const auto& term : terms) {
        const auto factor = static_cast<Real>(term.factor);
        const auto& rate = (*term.rates)[row];
        for (int axis = 0; axis < 4; ++axis) {
            record.position[axis] += factor * rate.position[axis];
            record.velocity[axis] += factor * rate.velocity[axis];
        }
    }
}

} // namespace

template<class Real>
void ExplicitWork<Real>::computeRates(const StepInput& input, double share, const State& at, State& rates) {
    const Loads& loads = *input.loads;
    if (active.areAll())
        kernel.rates(at, loads.gravity, rates);
    else
        kernel.rates(at, loads.gravity, rates, active.list());
    forOuterForces(loads, share, at,
                   [&rates](std::size_t row, double inverseMass, const Eigen::Vector3d& force) {
                       addToComponents(rates[row].velocity, inverseMass * force);
                   });
    for (const PrescribedNode& led : input.prescribed)
        setComponents(rates[kernel.rowOf(led.node)].velocity, Eigen::Vector3d::Zero());
}

template<class Real> void ExplicitWork<Real>::advance(State& to, std::initializer_list<Term> terms) const {
    forActiveRows([&to, terms, this](std::size_t row) {
        Record record = state[row];
        addRates<Real>(terms, row, record);
        to[row] = record;
    });
}

// The terms are summed up before they are added to the position, beside which each is small: added one by
// one, each would be rounded to the position's last digit.
template<class Real> void ExplicitWork<Real>::finish(std::initializer_list<Term> terms) {
    forActiveRows([terms, this](std::size_t row) {
        Record change{};
        addRates<Real>(terms, row, change);
        next[row] = state[row];
        for (int axis = 0; axis < 3; ++axis) {
            addKeeping(change.position[axis], row, axis, next[row].position[axis]);
            next[row].velocity[axis] += change.velocity[axis];
        }
    });
}

template<class Real>
const typename ExplicitWork<Real>::State& ExplicitWork<Real>::stage(std::initializer_list<Term> terms) {
    advance(between, terms);
    return between;
}

template struct ExplicitWork<float>;
template struct ExplicitWork<double>;

} // namespace esm
