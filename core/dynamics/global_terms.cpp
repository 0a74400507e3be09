#include "core/dynamics/global_terms.h"

#include <utility>

namespace esm {

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

GlobalCorrection::GlobalCorrection(GlobalTerms terms, std::vector<Vectors> responses)
    : m_terms(std::move(terms)), m_responses(std::move(responses)) {
    const auto size = static_cast<Eigen::Index>(m_terms.size());
    Eigen::MatrixXd coupling(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j < size; ++j)
            coupling(i, j) = scalarProduct(m_terms[static_cast<std::size_t>(i)].gradient,
                                           m_responses[static_cast<std::size_t>(j)]);
    for (Eigen::Index i = 0; i < size; ++i)
        coupling(i, i) += 1 / m_terms[static_cast<std::size_t>(i)].factor;
    m_coupling.compute(coupling);
}

Eigen::VectorXd GlobalCorrection::excess(const Vectors& solution) const {
    Eigen::VectorXd products(static_cast<Eigen::Index>(m_terms.size()));
    for (std::size_t i = 0; i < m_terms.size(); ++i)
        products[static_cast<Eigen::Index>(i)] = scalarProduct(m_terms[i].gradient, solution);
    return excessOf(products);
}

void GlobalCorrection::correct(Vectors& solution) const {
    if (isEmpty()) return;
    const Eigen::VectorXd shares = excess(solution);
    for (std::size_t i = 0; i < m_terms.size(); ++i)
        addMultiple(solution, -shares[static_cast<Eigen::Index>(i)], m_responses[i]);
}

} // namespace esm
