#include "core/solid/lattice_elasticity.h"

#include "tests/support/lattice_block.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Energy per volume of an endless lattice under a uniform strain, its nodes free to move within a repeating
/// box: springs are found by distance, and all nodes of the box go to equilibrium. It shares only the sites'
/// places with the code.
double energyUnder(LatticeKind kind, const Matrix3d& strain) {
    const UnitCell& cell = unitCellOf(kind);
    const double edge = 2 * cell.edge; // wider than twice the second neighbours
    std::vector<Vector3d> nodes;
    for (int place = 0; place < 8; ++place)
        for (const Vector3d& site : cell.sites)
            nodes.push_back(site + cell.edge * Vector3d(place & 1, place >> 1 & 1, place >> 2 & 1));
    const auto size = static_cast<Eigen::Index>(3 * nodes.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(size);
    double energy = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j)
            for (int image = 0; image < 27; ++image) {
                const Vector3d way =
                    nodes[j] - nodes[i] + edge * Vector3d(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
                const bool isNearest = std::abs(way.norm() - 1) < 1e-6;
                if (!isNearest && std::abs(way.norm() - test::secondDistance(kind)) > 1e-6) continue;
                const double half = (isNearest ? 1 : test::secondConstant(kind)) / 2; // each is met twice
                const Vector3d direction = way.normalized();
                const double lengthening = direction.dot(strain * way);
                const auto a = static_cast<Eigen::Index>(3 * i), b = static_cast<Eigen::Index>(3 * j);
                const Matrix3d block = half * direction * direction.transpose();
                stiffness.block<3, 3>(a, a) += block;
                stiffness.block<3, 3>(b, b) += block;
                stiffness.block<3, 3>(a, b) -= block;
                stiffness.block<3, 3>(b, a) -= block;
                force.segment<3>(a) += half * lengthening * direction;
                force.segment<3>(b) -= half * lengthening * direction;
                energy += half * lengthening * lengthening / 2;
            }
    const Eigen::VectorXd moved = stiffness.completeOrthogonalDecomposition().solve(force);
    return (energy - force.dot(moved) / 2) / std::pow(edge, 3);
}

Matrix3d strainOf(const Eigen::Matrix<double, 6, 1>& e) {
    Matrix3d strain;
    strain << e[0], e[5] / 2, e[4] / 2, e[5] / 2, e[1], e[3] / 2, e[4] / 2, e[3] / 2, e[2];
    return strain;
}

TEST(LatticeElasticity, AgreesWithTheEnergyOfARepeatingBoxAtRest) {
    for (const LatticeKind kind : {LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Diamond}) {
        const auto tensor = elasticityOf(kind).tensor;
        for (int i = 0; i < 8; ++i) {
            const Eigen::Matrix<double, 6, 1> strain =
                i < 6 ? Eigen::Matrix<double, 6, 1>(Eigen::Matrix<double, 6, 1>::Unit(i))
                      : Eigen::Matrix<double, 6, 1>(Eigen::Matrix<double, 6, 1>::Random());
            EXPECT_NEAR(energyUnder(kind, strainOf(strain)), 0.5 * strain.dot(tensor * strain), 1e-9)
                << wordOf(kind) << " strain " << i;
        }
    }
}

TEST(LatticeElasticity, IsThatOfAnIsotropicSolidOfAQuarter) {
    const double edge = 2 / std::sqrt(3.0); // of the body-centred cube
    const std::vector<std::pair<LatticeKind, double>> kinds{{LatticeKind::Cubic, 5.0 / 2},
                                                            {LatticeKind::BodyCentred, 5 / (3 * edge)}};
    for (const auto& [kind, modulus] : kinds) {
        const LatticeElasticity elasticity = elasticityOf(kind);
        EXPECT_NEAR(elasticity.anisotropy(), 1, 1e-12) << wordOf(kind);
        EXPECT_NEAR(elasticity.poissonsRatio(), 0.25, 1e-12) << wordOf(kind);
        EXPECT_NEAR(elasticity.youngsModulus(), modulus, 1e-12) << wordOf(kind);
        // An isotropic solid's tensor, from E and ν alone.
        const double shear = modulus / 2.5;
        Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Zero();
        expected.topLeftCorner<3, 3>().setConstant(shear);
        expected.diagonal() << 3 * shear, 3 * shear, 3 * shear, shear, shear, shear;
        EXPECT_LT((elasticity.tensor - expected).cwiseAbs().maxCoeff(), 1e-12) << wordOf(kind);
    }
}

// By hand: 16 nearest springs a cube give C11 = C12 = c/(3a) and nothing to shear, as the two kinds of nodes
// shift; 48 second ones of share s give C11 = 4sc/a, C12 = C44 = 2sc/a. So 2·C44/(C11 − C12) = 2 for every s.
TEST(LatticeElasticity, OfDiamondIsTwiceAsStiffAlongTheCube) {
    const LatticeElasticity elasticity = elasticityOf(LatticeKind::Diamond);
    const double edge = 4 / std::sqrt(3.0);
    EXPECT_NEAR(elasticity.tensor(0, 0), (1.0 / 3 + 4) / edge, 1e-9);
    EXPECT_NEAR(elasticity.tensor(0, 1), (1.0 / 3 + 2) / edge, 1e-9);
    EXPECT_NEAR(elasticity.tensor(3, 3), 2 / edge, 1e-9);
    EXPECT_NEAR(elasticity.anisotropy(), 2, 1e-9);
    EXPECT_NEAR(elasticity.poissonsRatio(), 0.2736, 1e-4);
}

TEST(LatticeElasticity, OfBareDiamondResistsNoShear) {
    const LatticeElasticity elasticity = elasticityOf(LatticeKind::BareDiamond);
    EXPECT_NEAR(elasticity.tensor(3, 3), 0, 1e-9);
    EXPECT_NEAR(elasticity.tensor(0, 0) - elasticity.tensor(0, 1), 0, 1e-9);
    EXPECT_GT(elasticity.tensor(0, 0), 0.1);
}

} // namespace
} // namespace esm
