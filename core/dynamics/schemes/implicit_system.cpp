#include "core/dynamics/schemes/implicit_system.h"

#include "core/dynamics/forces.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

using Eigen::Vector3d;

/// Some 12·√contrast of them are needed, and `auto` takes steps with a contrast of at most 5000
/// (stability.cpp).
constexpr int mostSolverIterations = 1000;

/// The nodes whose velocities are sought.
class UnknownNodes {
public:
    UnknownNodes(const StepMatrix& matrix, const std::vector<PrescribedNode>& prescribed, std::size_t count,
                 const GlobalTerms& terms)
        : m_matrix(matrix), m_given(count) {
        for (std::uint32_t i = 0; i < count; ++i)
            m_given[i] = matrix.isGiven(i);
        for (const PrescribedNode& led : prescribed)
            m_given[led.node] = 1;
        std::vector<Vectors> responses;
        for (const GlobalTerm& term : terms) {
            Vectors gradient = term.gradient;
            keep(gradient);
            responses.push_back(byMatrix(gradient));
        }
        m_correction = GlobalCorrection(terms, std::move(responses));
    }

    void keep(Vectors& vectors) const {
        for (std::size_t i = 0; i < vectors.size(); ++i)
            if (m_given[i]) vectors[i].setZero();
    }

    /// What the preconditioner makes of a residual: the solution with the matrix and the terms beside it.
    Vectors preconditioned(const Vectors& residual) const {
        Vectors result = byMatrix(residual);
        m_correction.correct(result);
        return result;
    }

private:
    Vectors byMatrix(const Vectors& residual) const {
        Vectors result(residual.size(), Vector3d::Zero()), half;
        m_matrix.solveLower(residual, result, half);
        m_matrix.solveUpper(std::move(half), result);
        keep(result);
        return result;
    }

    const StepMatrix& m_matrix;
    std::vector<char> m_given;
    GlobalCorrection m_correction;
};

enum class Solved { Yes, Indefinite, No };

// Conjugate gradients (Hestenes and Stiefel 1952), preconditioned. Given nodes stay in the matrix, but their
// rows are set to zero in every residual and image, the filter of Baraff and Witkin (1998): neither the
// tangent nor the factorised preconditioner has to change where other nodes are led.
//
// The preconditioned residual is measured against that of the momentum and of the start together. The
// momentum alone would not do: where only led nodes move there is none, and no residual would ever be small
// beside it.
//
// A direction without positive curvature shows that pressed springs buckle. What solves the equation is then
// a saddle of the potential, not its least place, and conjugate gradients may not get there either: the
// caller is told.
Solved conjugateGradients(const TangentMatrix& matrix, const UnknownNodes& unknown, const Vectors& momentum,
                          double tolerance, Vectors& velocities) {
    Vectors residual;
    matrix.multiply(velocities, residual);
    for (std::size_t i = 0; i < residual.size(); ++i)
        residual[i] = momentum[i] - residual[i];
    unknown.keep(residual);
    Vectors direction = unknown.preconditioned(residual), image;
    double rate = scalarProduct(residual, direction);
    const double scale = scalarProduct(momentum, unknown.preconditioned(momentum)) + rate;
    for (int iteration = 0; iteration < mostSolverIterations; ++iteration) {
        if (!(rate > tolerance * tolerance * scale)) return Solved::Yes;
        matrix.multiply(direction, image);
        unknown.keep(image);
        const double curvature = scalarProduct(direction, image);
        if (!(curvature > 0)) return Solved::Indefinite;
        addMultiple(velocities, rate / curvature, direction);
        addMultiple(residual, -rate / curvature, image);
        Vectors next = unknown.preconditioned(residual);
        const double nextRate = scalarProduct(residual, next);
        addMultiple(next, nextRate / rate, direction);
        direction = std::move(next);
        rate = nextRate;
    }
    return Solved::No;
}

} // namespace

TangentMatrix::TangentMatrix(const SpringSystem& system, Damping damping, const MatrixFactors& factors,
                             const Vectors& positions)
    : m_system(system), m_damping(damping), m_factors(factors),
      m_positions(system.cavities.empty() ? Vectors() : positions),
      m_globalTerms(globalTermsOf(system, positions, factors.stiffness)) {
    m_tangents.reserve(system.springs.size());
    for (const auto& spring : system.springs)
        m_tangents.push_back(tangentOf(spring, positions[spring.first] - positions[spring.second]));
    m_bent.reserve(system.hinges.size());
    for (const auto& hinge : system.hinges)
        m_bent.push_back(bentHinge(hinge, ofNodes(hinge, positions)));
    const std::vector<double> volumes = volumesOf(system, positions);
    for (std::size_t i = 0; i < volumes.size(); ++i)
        m_pressures.push_back(ownPressure(system.cavities[i], volumes[i]));
}

void TangentMatrix::addLoads(const Loads& loads, double endShare) {
    for (std::size_t i = 0; i < m_pressures.size(); ++i)
        m_pressures[i] += pressureOfLoads(loads, m_system.cavities[i], endShare);
}

// The least change that leaves each spring's part positive semidefinite (of a hinge what its square has), and
// with M the sum definite. The step then errs towards what is stiffer, and is as long as that allows.
void TangentMatrix::omitBuckling() {
    for (SpringTangent& tangent : m_tangents)
        tangent.lateral = std::max(0.0, tangent.lateral);
    m_omitsBuckling = true;
}

void TangentMatrix::makeDefinite() {
    omitBuckling();
    std::fill(m_pressures.begin(), m_pressures.end(), 0);
}

void TangentMatrix::multiply(const Vectors& velocities, Vectors& product) const {
    product.resize(velocities.size());
    for (std::size_t i = 0; i < product.size(); ++i)
        product[i] = m_factors.mass * m_system.mass[i] * velocities[i];
    addSprings(m_factors, velocities, product);
    addHinges(m_factors, velocities, product);
    addFluids(m_factors.stiffness, velocities, product);
}

Vectors TangentMatrix::stiffnessTimes(const Vectors& displacements) const {
    Vectors product(displacements.size(), Vector3d::Zero());
    addSprings({0, 0, 1}, displacements, product);
    addHinges({0, 0, 1}, displacements, product);
    addFluids(1, displacements, product);
    return product;
}

void TangentMatrix::addSprings(const MatrixFactors& factors, const Vectors& velocities,
                               Vectors& product) const {
    for (std::size_t i = 0; i < m_system.springs.size(); ++i) {
        const auto& spring = m_system.springs[i];
        const Vector3d force = resistance(spring, m_tangents[i], m_damping, factors,
                                          velocities[spring.first] - velocities[spring.second]);
        product[spring.first] += force;
        product[spring.second] -= force;
    }
    for (const Tether& tether : m_system.tethers)
        product[tether.node] +=
            (factors.damping * tether.viscosity + factors.stiffness * tether.springConstant) *
            velocities[tether.node];
}

void TangentMatrix::addHinges(const MatrixFactors& factors, const Vectors& velocities,
                              Vectors& product) const {
    for (std::size_t i = 0; i < m_system.hinges.size(); ++i) {
        const auto& hinge = m_system.hinges[i];
        const HingeVectors change = ofNodes(hinge, velocities);
        addToNodes(hinge, esm::stiffnessTimes(hinge, m_bent[i], !m_omitsBuckling, change), product,
                   factors.stiffness);
        addToNodes(hinge, dampingForces(hinge, change), product, -factors.damping);
    }
}

// With f = p(V)·g and g = ∂V/∂x, −∂f/∂x is σ·g·gᵀ − p·∂g/∂x.
void TangentMatrix::addFluids(double stiffnessFactor, const Vectors& velocities, Vectors& product) const {
    for (const GlobalTerm& term : m_globalTerms)
        addMultiple(product,
                    stiffnessFactor / m_factors.stiffness * term.factor *
                        scalarProduct(term.gradient, velocities),
                    term.gradient);
    for (std::size_t i = 0; i < m_pressures.size(); ++i) {
        if (m_pressures[i] == 0) continue;
        const CavityWall& wall = *m_system.cavities[i].wall;
        const Vectors change = gradientChange(wall, placesOf(wall, m_positions), placesOf(wall, velocities));
        for (std::size_t place = 0; place < change.size(); ++place)
            product[wall.nodes[place]] -= stiffnessFactor * m_pressures[i] * change[place];
    }
}

// Where the tangent is found to be indefinite, pressed springs buckle, or a pressure turns more than its wall
// holds, and both are left out of it. Not before: mostly their neighbours and their mass hold them, and forms
// whose order needs all of the tangent would lose it. The second try starts from the same place, since the
// first may have gone anywhere.
void solveImplicit(TangentMatrix& matrix, const StepMatrix& preconditioner,
                   const std::vector<PrescribedNode>& prescribed, const Vectors& momentum,
                   Vectors& velocities, double tolerance) {
    Vectors half;
    preconditioner.solveLower(momentum, velocities, half);
    Vectors start = velocities;
    preconditioner.solveUpper(std::move(half), start);
    for (const PrescribedNode& led : prescribed)
        start[led.node] = velocities[led.node];
    const UnknownNodes unknown(preconditioner, prescribed, velocities.size(), matrix.globalTerms());
    velocities = start;
    Solved solved = conjugateGradients(matrix, unknown, momentum, tolerance, velocities);
    if (solved == Solved::Indefinite) {
        matrix.makeDefinite();
        velocities = std::move(start);
        solved = conjugateGradients(matrix, unknown, momentum, tolerance, velocities);
    }
    if (solved != Solved::Yes)
        throw InvalidModel("the implicit step found no solution: shorten the step, or choose split");
}

} // namespace esm
