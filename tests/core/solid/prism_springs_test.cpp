#include "core/solid/prism_springs.h"

#include "core/solid/lattice_elasticity.h"
#include "core/solid/prism_wall.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double youngsModulus = 6000, width = 0.01; // Pa; of triangles, m
constexpr int columns = 24, rows = 8;
constexpr double length = columns * width, breadth = rows * width * 0.8660254037844386;

/// A flat strip of nearly regular triangles, along x.
TriangleMesh strip() {
    TriangleMesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const bool isEnd = column == 0 || column == columns;
            mesh.vertices.emplace_back(width * (column + (row % 2 == 1 && !isEnd ? 0.5 : 0)),
                                       breadth * row / rows, 0);
        }
    const auto at = [](int row, int column) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = at(row, column), b = at(row, column + 1), c = at(row + 1, column),
                                d = at(row + 1, column + 1);
            mesh.triangles.push_back(row % 2 == 1 ? Triangle{a, b, d} : Triangle{a, b, c});
            mesh.triangles.push_back(row % 2 == 1 ? Triangle{a, d, c} : Triangle{b, d, c});
        }
    return mesh;
}

/// Springs whose nodes go where they must, the others where they balance.
class Balance {
public:
    explicit Balance(const PrismWall& wall) : m_wall(wall), m_given(3 * wall.nodes.size()) {}

    /// @param axis 0 to 2
    void lead(std::size_t node, int axis, double by) {
        m_given[3 * node + static_cast<std::size_t>(axis)] = by;
    }

    /// J, of springs with these constants
    double energy() const {
        std::vector<int> numbers(m_given.size(), -1);
        int count = 0;
        for (std::size_t i = 0; i < m_given.size(); ++i)
            if (!m_given[i]) numbers[i] = count++;
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::VectorXd load = Eigen::VectorXd::Zero(count);
        double constant = 0;
        for (const LatticeSpring& spring : m_wall.springs) {
            const Eigen::Matrix<double, 6, 1> row = rowOf(spring);
            double given = 0;
            for (int i = 0; i < 6; ++i)
                given += row[i] * m_given[placeOf(spring, i)].value_or(0);
            constant += given * given / 2;
            for (int i = 0; i < 6; ++i) {
                const int one = numbers[placeOf(spring, i)];
                if (one < 0) continue;
                load[one] -= row[i] * given;
                for (int j = 0; j < 6; ++j)
                    if (const int other = numbers[placeOf(spring, j)]; other >= 0)
                        entries.emplace_back(one, other, row[i] * row[j]);
            }
        }
        Eigen::SparseMatrix<double> matrix(count, count);
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
        return constant - load.dot(factor.solve(load)) / 2;
    }

private:
    static std::size_t placeOf(const LatticeSpring& spring, int i) {
        return 3 * std::size_t{i < 3 ? spring.first : spring.second} + static_cast<std::size_t>(i % 3);
    }
    /// How much longer it becomes per way of its ends, times the root of its constant.
    Eigen::Matrix<double, 6, 1> rowOf(const LatticeSpring& spring) const {
        const Vector3d along = (m_wall.nodes[spring.second] - m_wall.nodes[spring.first]).normalized();
        Eigen::Matrix<double, 6, 1> row;
        row << -along, along;
        return std::sqrt(spring.constant) * row;
    }

    const PrismWall& m_wall;
    std::vector<std::optional<double>> m_given;
};

PrismWall stripWall(double thickness, int layers) {
    const LatticeFilling filling{LatticeKind::Prisms, 0, thickness, layers};
    PrismWall wall = prismWall(strip(), filling);
    for (LatticeSpring& spring : wall.springs)
        spring.constant *= latticeConstant(filling, youngsModulus);
    return wall;
}

/// Both ends pulled apart, or turned against each other, over what a beam of the tissue resists with.
double stiffnessOf(double thickness, int layers, bool isBent) {
    const PrismWall wall = stripWall(thickness, layers);
    Balance balance(wall);
    bool leadsAcross = true;
    for (std::size_t i = 0; i < wall.nodes.size(); ++i) {
        const Vector3d& place = wall.nodes[i];
        if (place.x() > 1e-9 && place.x() < length - 1e-9) continue;
        const double fromMiddle = place.z() + thickness / 2;
        balance.lead(i, 0, isBent ? (place.x() - length / 2) * fromMiddle : place.x());
        if (std::abs(place.z()) < 1e-9) balance.lead(i, 2, 0);
        if (std::exchange(leadsAcross, false)) balance.lead(i, 1, 0);
    }
    const double whole = youngsModulus * thickness * length * breadth / 2;
    return balance.energy() / (isBent ? whole * thickness * thickness / 12 : whole);
}

TEST(PrismSprings, StretchAsASheetOfTheTissue) {
    for (const double thickness : {0.001, 0.003, 0.006, 0.01})
        for (const int layers : {1, 2, 3, 4})
            EXPECT_NEAR(stiffnessOf(thickness, layers, false), 1, 0.05) << thickness << " m, " << layers;
}

TEST(PrismSprings, BendAsAPlateOfTheTissueInTwoLayersOrMore) {
    for (const double thickness : {0.001, 0.003, 0.006, 0.01}) {
        for (const int layers : {2, 3, 4, 6})
            EXPECT_NEAR(stiffnessOf(thickness, layers, true), 1, 0.03) << thickness << " m, " << layers;
        EXPECT_NEAR(stiffnessOf(thickness, 1, true), 2.85, 0.1) << thickness << " m";
    }
}

} // namespace
} // namespace esm
