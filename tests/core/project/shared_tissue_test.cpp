#include "core/project/shared_tissue.h"

#include "core/project/project.h"
#include "core/project/simulated_network.h"
#include "core/solid/lattice_elasticity.h"
#include "tests/support/solid_surfaces.h"

#include <gtest/gtest.h>

#include <numeric>

namespace esm {
namespace {

const TriangleMesh cuboid = test::block({0, 0, 0}, {0.06, 0.04, 0.05});
constexpr double volume = 0.06 * 0.04 * 0.05; // m³

TissueModel evenTissue(const LatticeFilling& filling) {
    TissueModel model;
    model.network =
        std::make_shared<const SpringNetwork>(networkOf(cuboid, {Detail::Kind::Filled, 0, filling}));
    model.springConstant.assign(model.network->restPositions.size(), 12.5);
    model.viscosity.assign(model.network->restPositions.size(), 0.5);
    return model;
}

/// J, when the body is stretched evenly: of isotropic tissue with ν = 1/4 along an axis 0.6·E·ε² for each m³.
double stretchingEnergy(const TissueModel& model, const std::vector<SpringValues>& values,
                        const Eigen::Vector3d& direction, double strain) {
    double energy = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto& [first, second, length] = model.network->springs[i];
        const Eigen::Vector3d along =
            (model.network->restPositions[second] - model.network->restPositions[first]) / length;
        const double longer = strain * length * std::pow(along.dot(direction), 2);
        energy += values[i].springConstant * longer * longer / 2;
    }
    return energy;
}

TEST(SolidTissue, IsAsFirmHoweverFineItsLatticeIs) {
    const double modulus = youngsModulusOfWall(12.5, usualWallThickness);
    EXPECT_NEAR(modulus, 4811, 1);
    for (const LatticeKind kind : {LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Graded})
        for (const double spacing : {0.005, 0.004, 0.003}) {
            const TissueModel model = evenTissue({kind, spacing});
            for (const Eigen::Vector3d& direction :
                 {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 2, 3).normalized()})
                EXPECT_NEAR(
                    stretchingEnergy(model, sharedValues(model, usualWallThickness), direction, 1e-3) /
                        (0.6 * modulus * 1e-6 * volume),
                    1, 0.05)
                    << wordOf(kind) << spacing;
        }
}

TEST(SolidTissue, RelaxesAsFastHoweverFineItsLatticeIs) {
    for (const double spacing : {0.01, 0.004}) {
        const TissueModel model = evenTissue({LatticeKind::BodyCentred, spacing});
        const std::vector<SpringValues> values = sharedValues(model, usualWallThickness);
        ASSERT_EQ(values.size(), model.network->springs.size());
        for (const SpringValues& spring : values)
            EXPECT_NEAR(spring.viscosity / spring.springConstant, 0.5 / 12.5, 1e-12);
    }
}

TEST(SolidTissue, OfABareDiamondLatticeResistsCompressionAsTheOthersDo) {
    const TissueModel model = evenTissue({LatticeKind::BareDiamond, 0.004});
    double energy = 0;
    const std::vector<SpringValues> values = sharedValues(model, usualWallThickness);
    for (std::size_t i = 0; i < values.size(); ++i)
        energy += values[i].springConstant * std::pow(1e-3 * model.network->springs[i].restLength, 2) / 2;
    // Squeezed evenly from all sides, 9·K·ε²/2 for each m³; K = 2E/3.
    EXPECT_NEAR(energy / (3 * youngsModulusOfWall(12.5, usualWallThickness) * 1e-6 * volume), 1, 0.1);
}

TEST(SolidTissue, WeighsWhatTheOrganWeighsWhereItsVolumeIs) {
    const SpringNetwork network =
        networkOf(cuboid, {Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::BodyCentred, 0.008}});
    const std::vector<double> sizes = nodeSizes(network);
    const auto nodes = static_cast<double>(sizes.size());
    EXPECT_NEAR(std::accumulate(sizes.begin(), sizes.end(), 0.0), nodes, 1e-9 * nodes);
    Eigen::Vector3d centre(0, 0, 0);
    for (std::size_t i = 0; i < sizes.size(); ++i)
        centre += sizes[i] / nodes * network.restPositions[i];
    EXPECT_LT((centre - Eigen::Vector3d(0.03, 0.02, 0.025)).norm(), 1e-3);
    EXPECT_EQ(nodeSizes(networkOf(cuboid, {})), std::vector<double>(8, 1));
}

} // namespace
} // namespace esm
