#include "core/probing/probe.h"

#include "core/dynamics/statics/pressed_tissue.h"
#include "core/project/shared_tissue.h"
#include "core/project/simulated_network.h"
#include "core/project/wall.h"
#include "tests/support/calculix.h"
#include "tests/support/sanitized.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

// Lattices against another program's finite elements.
namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double springOfLattice = 10; ///< N/m

double modulusOfLattice() {
    return youngsModulusOfWall(springOfLattice, usualWallThickness);
}

/// A block filled with a lattice, its nodes fixed where `isFixed` says so.
TissueModel heldLattice(const SpringNetwork& network, const std::function<bool(const Vector3d&)>& isFixed) {
    TissueModel model = tissue::model(network, {springOfLattice, 0.1, 1e-3});
    model.ownValues = sharedValues(model, usualWallThickness);
    for (std::uint32_t node = 0; node < network.restPositions.size(); ++node)
        if (isFixed(network.restPositions[node])) model.fixedNodes.push_back(node);
    return model;
}

SpringNetwork latticeOf(const TriangleMesh& mesh, double spacing) {
    return networkOf(mesh, {Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::BodyCentred, spacing}});
}

/// From 0 to a length; closer by 0 the larger the power.
std::vector<double> planes(double length, std::size_t count, double power = 1) {
    std::vector<double> result;
    for (std::size_t i = 0; i <= count; ++i)
        result.push_back(length * std::pow(static_cast<double>(i) / static_cast<double>(count), power));
    return result;
}

/// A beam along x, clamped at 0, that a finger presses down above a place near its free end.
struct Beam {
    double length = 0.1, width = 0.02, pressedAt = 0.09; ///< m
};

/// m/N: by how much the free end goes down.
double deflectionByElements(const Beam& beam, double poissonsRatio) {
    const test::BrickBlock block{planes(beam.length, 40), planes(beam.width, 8), planes(beam.width, 8),
                                 modulusOfLattice(), poissonsRatio};
    test::BrickLoads loads;
    for (std::size_t y = 0; y < 9; ++y)
        for (std::size_t z = 0; z < 9; ++z)
            for (const int axis : {1, 2, 3})
                loads.led[{block.nodeAt(0, y, z), axis}] = 0;
    loads.forces[{block.nodeAt(36, 4, 8), 3}] = -1;
    return -test::restOf(block, loads).displacements.at(block.nodeAt(40, 4, 4)).z();
}

double deflectionOfLattice(const Beam& beam, double spacing) {
    const TriangleMesh mesh =
        test::block({0, -beam.width / 2, -beam.width}, {beam.length, beam.width / 2, 0});
    const SpringNetwork network = latticeOf(mesh, spacing);
    const TissueModel model = heldLattice(network, [](const Vector3d& at) { return at.x() < 1e-6; });
    const SpringSystem system = makeSpringSystem(model);
    constexpr double radius = 0.03, depth = 0.002;
    PressedTissue pressed(system, touchedSurface(mesh, network).triangles,
                          {radius, {beam.pressedAt, 0, radius}, -Vector3d::UnitZ()});
    pressed.settle(AtDepth{depth});
    double sum = 0;
    int count = 0;
    for (std::size_t node = 0; node < network.restPositions.size(); ++node)
        if (network.restPositions[node].x() > beam.length - 1e-6) {
            sum += network.restPositions[node].z() - pressed.positions()[node].z();
            ++count;
        }
    return sum / count / pressed.force();
}

TEST(FiniteElements, DeflectABeamAsItsLatticeDoes) {
    if (!test::hasCalculix()) GTEST_SKIP() << "ccx is not here: install calculix-ccx";
    const Beam beam;
    const double solid = deflectionByElements(beam, 0.25);
    EXPECT_NEAR(deflectionOfLattice(beam, 0.005), solid, 0.1 * solid);
}

/// A block on a fixed ground, that a sphere presses in the middle.
struct Indented {
    double width = 0.06, height = 0.03, radius = 0.06, depth = 0.002; ///< m
};

/// N. A quarter of it; the nodes under the sphere are led to where it is, and those that it would have to
/// pull are let go, until there are none.
double forceByElements(const Indented& wanted, double poissonsRatio, std::size_t cells) {
    test::BrickBlock block{planes(wanted.width / 2, cells, 1.7),
                           planes(wanted.width / 2, cells, 1.7),
                           {},
                           modulusOfLattice(),
                           poissonsRatio};
    for (const double below : planes(wanted.height, cells, 1.7))
        block.zs.insert(block.zs.begin(), -below);
    test::BrickLoads held;
    for (std::size_t i = 0; i <= cells; ++i)
        for (std::size_t j = 0; j <= cells; ++j) {
            held.led[{block.nodeAt(0, i, j), 1}] = 0;
            held.led[{block.nodeAt(i, 0, j), 2}] = 0;
            for (const int axis : {1, 2, 3})
                held.led[{block.nodeAt(i, j, 0), axis}] = 0;
        }
    std::map<int, double> beneath;
    for (std::size_t i = 0; i <= cells; ++i)
        for (std::size_t j = 0; j <= cells; ++j) {
            const double away = std::hypot(block.xs[i], block.ys[j]);
            const double gap = wanted.radius - std::sqrt(wanted.radius * wanted.radius - away * away);
            if (gap < wanted.depth) beneath[block.nodeAt(i, j, cells)] = gap - wanted.depth;
        }
    while (true) {
        test::BrickLoads loads = held;
        for (const auto& [node, way] : beneath)
            loads.led[{node, 3}] = way;
        const test::BrickRest rest = test::restOf(block, loads);
        double force = 0;
        const std::size_t before = beneath.size();
        for (const auto& [node, vector] : rest.forces)
            if (beneath.count(node) > 0) {
                force -= vector.z();
                if (vector.z() > 0) beneath.erase(node);
            }
        if (beneath.size() == before) return 4 * force;
    }
}

double forceOnLattice(const Indented& wanted, double spacing) {
    const TriangleMesh mesh = test::block({-wanted.width / 2, -wanted.width / 2, -wanted.height},
                                          {wanted.width / 2, wanted.width / 2, 0});
    const SpringNetwork network = latticeOf(mesh, spacing);
    const TissueModel model =
        heldLattice(network, [&](const Vector3d& at) { return at.z() < 1e-6 - wanted.height; });
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue pressed(system, touchedSurface(mesh, network).triangles,
                          {wanted.radius, {0, 0, wanted.radius}, -Vector3d::UnitZ()});
    pressed.settle(AtDepth{wanted.depth});
    return pressed.force();
}

TEST(FiniteElements, AreIndentedAsALatticeIs) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    if (!test::hasCalculix()) GTEST_SKIP() << "ccx is not here: install calculix-ccx";
    const Indented block;
    const double solid = forceByElements(block, 0.25, 12);
    EXPECT_NEAR(forceOnLattice(block, 0.004), solid, 0.1 * solid);
}

// Lattices have no other Poisson's ratio than 1/4: this is how far off they are for a solid of the same
// modulus that hardly gives way in volume, as said in docs/virtual-tests.md.
TEST(FiniteElements, AreIndentedLessEasilyWhereASolidKeepsItsVolume) {
    if (!test::hasCalculix()) GTEST_SKIP() << "ccx is not here: install calculix-ccx";
    const Indented block;
    EXPECT_NEAR(forceByElements(block, 0.45, 8) / forceByElements(block, 0.25, 8), 1.22, 0.03);
    const Beam beam;
    EXPECT_NEAR(deflectionByElements(beam, 0.45) / deflectionByElements(beam, 0.25), 0.98, 0.01);
}

} // namespace
} // namespace esm
