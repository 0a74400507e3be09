#pragma once

#include "core/dynamics/elimination/block_factor.h"
#include "core/dynamics/matrix_factors.h"
#include "core/dynamics/spring_system.h"

#include <memory>
#include <optional>
#include <vector>

namespace esm {

/// massFactor·M + dampingFactor·D + stiffnessFactor·K over the nodes that are not given, in the order of
/// the nodes; lower half. D and K are the graph Laplacians of viscosities and largest spring constants, with
/// the tethers' on the diagonal and w·wᵀ of each hinge: the same for x, y and z.
Eigen::SparseMatrix<double> laplacianMatrix(const SpringSystem& system, const MatrixFactors& factors,
                                            const std::vector<char>& given);

/// Factorises matrices one after the other. Where their entries lie in the same places, all but the first
/// find the order of elimination and the places of the factor's entries known.
class MatrixFactoriser {
public:
    using Matrix = Eigen::SparseMatrix<double>;

    /// The lower half of a matrix as L·Lᵀ; none when it is not positive definite.
    /// @param places of its rows, m: rows that are coupled lie close together, or it takes long
    std::optional<BlockFactor> factorise(const Matrix& matrix, const Vectors& places);

    /// s, wall time of all of them so far.
    double seconds() const { return m_seconds; }

private:
    bool isPlanned(const Matrix& matrix, const Vectors& places) const;

    std::shared_ptr<const FactorPlan> m_plan;
    // Of the matrix that it was made for: the columns' starts, the entries' rows, and where the rows lie.
    std::vector<int> m_starts, m_rows;
    Vectors m_places;
    double m_seconds = 0;
};

/// A = massFactor·M + dampingFactor·D + stiffnessFactor·K, factorised as L·Lᵀ once and solved for three
/// right-hand sides at a time. Velocities of given nodes are given, not solved for. With masses alone
/// both are diagonal.
///
/// A solve is two halves so that impulses can be laid on single nodes between them: A⁻¹ between two nodes is
/// the product of their half columns.
class StepMatrix {
public:
    /// @throws InvalidModel when masses are too small beside damping or stiffness for the arithmetic
    StepMatrix(const SpringSystem& system, const MatrixFactors& factors, const std::vector<char>& given,
               MatrixFactoriser& factoriser);

    bool isGiven(std::uint32_t node) const { return m_row[node] < 0; }
    /// Numbers that the factor keeps.
    std::size_t factorValues() const { return m_factor.valueCount(); }

    /// L⁻¹·(momentum − what the given nodes' velocities take from it), in the factor's own order.
    void solveLower(const Vectors& momentum, const Vectors& velocities, Vectors& half) const;
    /// Lᵀ·velocities: what solveUpper() makes velocities of.
    void multiplyUpper(const Vectors& velocities, Vectors& half) const;
    /// Velocities of all that are not given.
    void solveUpper(Vectors half, Vectors& velocities) const;

    /// Precondition: none of the nodes is given.
    std::vector<HalfColumn> halfColumns(const std::vector<std::uint32_t>& nodes) const;

private:
    struct Coupling {
        int row;
        std::uint32_t prescribedNode;
        double factor;
    };

    void checkAccuracy(const SpringSystem& system, const MatrixFactors& factors) const;

    BlockFactor m_factor;
    std::vector<int> m_row;            ///< per node, in the factor's order; −1: given
    std::vector<Coupling> m_couplings; ///< between free and given nodes
};

} // namespace esm
