#include "core/dynamics/schemes/global_terms.h"

#include <utility>

namespace esm {

namespace {

/// With the matrix alone. Led nodes that are in it come between its two halves: there an impulse on a single
/// node is one sparse column, and the impulses that give all of them their velocities are a small dense
/// system.
void solveAlone(StepSolver& solver, const std::vector<std::uint32_t>& led, const Vectors& momentum,
                Vectors& velocities, Vectors& half) {
    solver.matrix.solveLower(momentum, velocities, half);
    if (!led.empty()) solver.impulses.lead(led, velocities, half);
    solver.matrix.solveUpper(half, velocities);
}

} // namespace

double scalarProduct(const Vectors& a, const Vectors& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i].dot(b[i]);
    return sum;
}

void addMultiple(Vectors& target, double factor, const Vectors& vectors) {
    for (std::size_t i = 0; i < target.size(); ++i)
        target[i] += factor * vectors[i];
}

GlobalTerms globalTermsOf(const SpringSystem& system, const Vectors& positions, double stiffnessFactor) {
    GlobalTerms terms;
    for (const SpringSystem::Filled& cavity : system.cavities) {
        if (cavity.stiffness == 0) continue;
        GlobalTerm term{stiffnessFactor * pressureSlope(cavity),
                        Vectors(positions.size(), Eigen::Vector3d::Zero())};
        const Vectors gradient = volumeOf(*cavity.wall, placesOf(*cavity.wall, positions)).gradient;
        for (std::size_t place = 0; place < gradient.size(); ++place)
            term.gradient[cavity.wall->nodes[place]] = gradient[place];
        terms.push_back(std::move(term));
    }
    return terms;
}

GlobalCorrection::GlobalCorrection(const GlobalTerms& terms, std::vector<Vectors> responses)
    : m_responses(std::move(responses)) {
    const auto size = static_cast<Eigen::Index>(terms.size());
    Eigen::MatrixXd coupling(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j < size; ++j)
            coupling(i, j) = scalarProduct(terms[static_cast<std::size_t>(i)].gradient,
                                           m_responses[static_cast<std::size_t>(j)]);
    for (Eigen::Index i = 0; i < size; ++i)
        coupling(i, i) += 1 / terms[static_cast<std::size_t>(i)].factor;
    m_coupling.compute(coupling);
}

Eigen::VectorXd GlobalCorrection::excess(const GlobalTerms& terms, const Vectors& solution) const {
    Eigen::VectorXd products(static_cast<Eigen::Index>(terms.size()));
    for (std::size_t i = 0; i < terms.size(); ++i)
        products[static_cast<Eigen::Index>(i)] = scalarProduct(terms[i].gradient, solution);
    return m_coupling.solve(products);
}

void GlobalCorrection::correct(const GlobalTerms& terms, Vectors& solution) const {
    if (terms.empty()) return;
    const Eigen::VectorXd shares = excess(terms, solution);
    for (std::size_t i = 0; i < terms.size(); ++i)
        addMultiple(solution, -shares[static_cast<Eigen::Index>(i)], m_responses[i]);
}

// The terms' gradients turn with the tissue and are new in every step, while the matrix stays factorised:
// each costs a further solve with it. Gradients kept from rest would save that, but a term along another
// gradient than that of the force resists what is no change of volume, and leaves changes of volume
// unresisted: tissue that has turned would run away.
void solveStep(StepSolver& solver, const std::vector<PrescribedNode>& prescribed, const GlobalTerms& terms,
               const Vectors& momentum, Vectors& velocities, Vectors& half) {
    const std::vector<std::uint32_t> led = ledByImpulses(solver.matrix, prescribed);
    solveAlone(solver, led, momentum, velocities, half);
    if (terms.empty()) return;
    std::vector<Vectors> responses, halfResponses;
    for (const GlobalTerm& term : terms) {
        responses.emplace_back(velocities.size(), Eigen::Vector3d::Zero());
        solveAlone(solver, led, term.gradient, responses.back(), halfResponses.emplace_back());
    }
    const Eigen::VectorXd shares = GlobalCorrection(terms, responses).excess(terms, velocities);
    for (std::size_t i = 0; i < terms.size(); ++i) {
        addMultiple(velocities, -shares[static_cast<Eigen::Index>(i)], responses[i]);
        addMultiple(half, -shares[static_cast<Eigen::Index>(i)], halfResponses[i]);
    }
}

} // namespace esm
