#include "core/dynamics/schemes/step_solvers.h"

#include <cmath>

namespace esm {

namespace {

/// Kept of a kind. Steps that are cut to ever other lengths ask for ever other matrices, which take memory.
constexpr std::size_t mostSolvers = 24;
/// Of large ones, once their factors take a gigabyte.
constexpr std::size_t mostLargeSolvers = 4, mostValues = std::size_t{1} << 27;

using Kept = std::unique_ptr<StepSolver>;

template<class Key> bool isFull(const std::map<Key, Kept>& solvers) {
    std::size_t values = 0;
    for (const auto& [key, solver] : solvers)
        values += solver->matrix.factorValues();
    return solvers.size() >= mostSolvers || (solvers.size() >= mostLargeSolvers && values >= mostValues);
}

template<class Key, class Make>
StepSolver& knownOrMade(std::map<Key, Kept>& solvers, const Key& key, const Make& make) {
    if (const auto known = solvers.find(key); known != solvers.end()) return *known->second;
    if (isFull(solvers)) solvers.clear();
    auto solver = std::make_unique<StepSolver>(make());
    return *(solvers[key] = std::move(solver));
}

} // namespace

long lengthOf(double duration) {
    constexpr double parts = 1 << 28;
    return std::lround(parts * std::log2(duration));
}

StepSolvers::StepSolvers(std::vector<char> given, std::shared_ptr<MatrixFactoriser> factoriser)
    : m_given(std::move(given)), m_factoriser(std::move(factoriser)) {}

StepSolver& StepSolvers::linear(const SpringSystem& system, Integrator integrator, double duration,
                                bool builds) {
    return knownOrMade(m_linear, std::pair(lengthOf(duration), builds), [&] {
        return StepMatrix(system, stepFactors(integrator, duration, builds), m_given, *m_factoriser);
    });
}

StepSolver& StepSolvers::branch(const SpringSystem& system, const StrainedSprings& strained,
                                Integrator integrator, double duration) {
    return knownOrMade(m_branches, lengthOf(duration), [&] {
        return StepMatrix(strained.linearised(system), stepFactors(integrator, duration, false), m_given,
                          *m_factoriser);
    });
}

} // namespace esm
