#pragma once

#include "core/dynamics/elimination/factor_plan.h"
#include "core/dynamics/kernel/large_pages.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace esm {

/// A column of L⁻¹: its entries, from the top down. They lie on one path of the elimination tree, so two
/// columns end in the same rows from where their paths meet.
struct HalfColumn {
    std::vector<int> rows;
    std::vector<double> values;
};

/// L of A = L·Lᵀ, its rows in an order of its own.
class BlockFactor {
public:
    /// Of a matrix without rows.
    BlockFactor() : m_plan(std::make_shared<const FactorPlan>()) {}

    /// Of a matrix with entries in the places of that which the plan was made for; none where it is not
    /// positive definite.
    static std::optional<BlockFactor> of(const Eigen::SparseMatrix<double>& lower,
                                         std::shared_ptr<const FactorPlan> plan);

    std::size_t rowCount() const { return m_plan->places.size(); }
    std::size_t valueCount() const { return m_values.size(); }
    /// The factor's row for each row of the matrix.
    const std::vector<int>& places() const { return m_plan->places; }

    /// L⁻¹·vectors and L⁻ᵀ·vectors in place, three right-hand sides at a time.
    void solveLower(std::vector<Eigen::Vector3d>& vectors) const;
    void solveUpper(std::vector<Eigen::Vector3d>& vectors) const;
    /// Lᵀ·vectors
    std::vector<Eigen::Vector3d> multiplyUpper(const std::vector<Eigen::Vector3d>& vectors) const;
    /// Those of some rows, each as if it were asked for alone.
    std::vector<HalfColumn> halfColumns(const std::vector<int>& rows) const;

private:
    std::vector<int> wayFrom(int row) const;
    void solveUnits(std::span<const int> rows, std::vector<Eigen::Vector3d>& zeros,
                    std::vector<HalfColumn>& columns) const;

    explicit BlockFactor(std::shared_ptr<const FactorPlan> plan)
        : m_plan(std::move(plan)), m_values(m_plan->valueCount, 0.0) {}

    std::shared_ptr<const FactorPlan> m_plan;
    LargeVector<double> m_values;
};

} // namespace esm
