#include "core/solid/filled_body.h"

#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/repair.h"
#include "core/solid/relaxation.h"
#include "core/solid/trimming.h"
#include "core/support/errors.h"
#include "tests/support/crossed_ball.h"
#include "tests/support/fitted_lattice.h"
#include "tests/support/sanitized.h"
#include "tests/support/shared_data.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/steady_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>
#include <numeric>

namespace esm {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

const std::vector<LatticeKind> stiffKinds{LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Graded,
                                          LatticeKind::Diamond};

/// What every filling promises, whatever the surface.
void expectSound(const TriangleMesh& mesh, const FilledBody& filled, const LatticeFilling& filling) {
    const double deepest = 1.04 * deepestChord(filling.kind, filling.spacing);
    const std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    ASSERT_EQ(filled.bodyStarts.size(), bodies.size() + 1);
    const double size = boundingBox(mesh.vertices).sizes().maxCoeff();
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        const BodyQuery query(bodies[body]);
        EXPECT_GT(filled.bodyStarts[body + 1], filled.bodyStarts[body]) << "a part without nodes";
        for (std::uint32_t i = filled.bodyStarts[body]; i < filled.bodyStarts[body + 1]; ++i) {
            const double distance = query.nearest(filled.nodes[i]).distance;
            EXPECT_TRUE(distance < 1e-9 * size || query.contains(filled.nodes[i])) << "node " << i;
            EXPECT_EQ(filled.isOnSurface[i] != 0, distance < 1e-9 * size) << "node " << i;
        }
        for (const LatticeSpring& spring : filled.springs) {
            if (spring.first < filled.bodyStarts[body] || spring.first >= filled.bodyStarts[body + 1])
                continue;
            ASSERT_LT(spring.second, filled.bodyStarts[body + 1]) << "a spring from body to body";
            EXPECT_GT(spring.constant, 0);
            // Looked at in many places: a chord outside is near the surface.
            for (int step = 1; step < 8; ++step) {
                const Vector3d place =
                    filled.nodes[spring.first] +
                    step / 8.0 * (filled.nodes[spring.second] - filled.nodes[spring.first]);
                EXPECT_TRUE(query.nearest(place).distance < deepest || query.contains(place));
            }
        }
    }
    for (const Tetrahedron& tetrahedron : filled.tetrahedra)
        EXPECT_GT(shapeOf(tetrahedron, filled.nodes), 0.02);
}

double volumeError(const FilledBody& filled) {
    return test::totalVolume(filled.tetrahedra, filled.nodes) / filled.enclosedVolume - 1;
}

TEST(FilledBody, HoldsWhatItPromises) {
    for (const LatticeKind kind : stiffKinds) {
        const TriangleMesh mesh = lumpySurface(30, 60);
        const FilledBody filled = fillBody(mesh, {kind, 0.016});
        expectSound(mesh, filled, {kind, 0.016});
        const Rigidity rigidity = rigidityOf(filled.nodes, filled.springs);
        EXPECT_EQ(rigidity.bodies, 1U) << wordOf(kind);
        EXPECT_EQ(rigidity.floppyModes, 0U) << wordOf(kind);
    }
}

TEST(FilledBody, HasTheVolumeOfTheSurface) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    for (const LatticeKind kind : stiffKinds) {
        EXPECT_NEAR(volumeError(fillBody(lumpySurface(60, 120), {kind, 0.005})), 0, 0.005) << wordOf(kind);
        EXPECT_NEAR(volumeError(fillBody(test::torus(48, 24), {kind, 0.036})), 0, 0.005) << wordOf(kind);
    }
}

TEST(FilledBody, FillsPartsCavitiesAndPartsWithinThem) {
    TriangleMesh mesh = test::shell(1, 0.6);
    test::append(mesh, test::ball(0.25, {0.1, 0, 0}));    // in the cavity
    test::append(mesh, test::ball(0.02, {1.5, 0, 0}, 8)); // smaller than the spacing
    for (const LatticeKind kind : stiffKinds) {
        const FilledBody filled = fillBody(mesh, {kind, 0.13});
        expectSound(mesh, filled, {kind, 0.13});
        EXPECT_EQ(filled.bodyStarts.size(), 4U);
        EXPECT_NEAR(volumeError(filled), 0, 0.05) << wordOf(kind);
        const Rigidity rigidity = rigidityOf(filled.nodes, filled.springs);
        EXPECT_EQ(rigidity.bodies, 3U) << wordOf(kind);
        EXPECT_EQ(rigidity.floppyModes, 0U) << wordOf(kind);
    }
}

TEST(FilledBody, FillsAThinPlateWithAFineLattice) {
    const TriangleMesh mesh = test::block({0, 0, 0}, {0.03, 0.02, 0.004});
    for (const LatticeKind kind : stiffKinds) {
        const FilledBody filled = fillBody(mesh, {kind, 0.0017});
        expectSound(mesh, filled, {kind, 0.0017});
        EXPECT_EQ(rigidityOf(filled.nodes, filled.springs).floppyModes, 0U) << wordOf(kind);
        EXPECT_GT(volumeError(filled), -0.1) << wordOf(kind);
    }
}

TEST(FilledBody, OfBareDiamondIsFloppy) {
    const FilledBody filled = fillBody(lumpySurface(30, 60), {LatticeKind::BareDiamond, 0.006});
    const Rigidity rigidity = rigidityOf(filled.nodes, filled.springs);
    EXPECT_EQ(rigidity.bodies, 1U);
    EXPECT_GT(rigidity.floppyModes, filled.nodes.size() / 4);
}

TEST(FilledBody, FillsEveryClosedOrganThatIsHere) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    for (const char* const name :
         {"sofa-liver-coarse.obj", "sofa-aneurysm.off", "sks-liver-downsample.stl", "sks-liver-coloured.ply",
          "sks-liver-H07.ply", "colin27-lateral-ventricles-ascii.stl"}) {
        const auto file = sharedData("meshes") / name;
        ESM_SKIP_WITHOUT(file);
        const TriangleMesh mesh = repair(readMeshFile(file)).mesh;
        double volume = 0;
        for (const ClosedBody& body : closedBodiesOf(mesh))
            volume += body.volume;
        SCOPED_TRACE(name);
        const double spacing = std::cbrt(1.3 * volume / 1000);
        const FilledBody filled = fillBody(mesh, {LatticeKind::BodyCentred, spacing});
        expectSound(mesh, filled, {LatticeKind::BodyCentred, spacing});
        const Rigidity rigidity = rigidityOf(filled.nodes, filled.springs);
        EXPECT_EQ(rigidity.floppyModes, 0U);
        EXPECT_EQ(rigidity.bodies, filled.bodyStarts.size() - 1);
        EXPECT_NEAR(volumeError(fillBody(mesh, {LatticeKind::BodyCentred, spacing / 3.7})), 0, 0.005);
    }
}

TEST(FilledBody, PassesOverASmallPlaceWhereTheSurfaceRunsThroughItself) {
    const TriangleMesh mesh = test::crossedBall();
    for (const LatticeKind kind : stiffKinds) {
        if (isSanitized() && kind != LatticeKind::BodyCentred) continue; // all are cut alike
        const FilledBody filled = fillBody(mesh, {kind, 0.12});
        expectSound(mesh, filled, {kind, 0.12});
        EXPECT_EQ(rigidityOf(filled.nodes, filled.springs).floppyModes, 0U) << wordOf(kind);
        const double without = volumeError(fillBody(test::ball(1, {0, 0, 0}, 48), {kind, 0.12}));
        EXPECT_NEAR(volumeError(filled), without, 0.002) << wordOf(kind);
        const NarrowCrossings crossings = estimateLattice(mesh, {kind, 0.12}).crossings;
        EXPECT_EQ(crossings.places, 1U);
        EXPECT_NEAR(crossings.width, 0.04, 0.02);
    }
    EXPECT_EQ(estimateLattice(test::torus(), {LatticeKind::Cubic, 0.05}).crossings.places, 0U);
}

TEST(FilledBody, PassesOverTheSmallCrossingsOfOrgans) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    struct Organ {
        const char* name;
        std::size_t crossings;
    };
    for (const auto& [name, crossings] : {Organ{"liver-smoothUV.obj", 1}, Organ{"VH_F_Skin.glb", 2}}) {
        const auto file = sharedData("meshes") / name;
        ESM_SKIP_WITHOUT(file);
        const TriangleMesh mesh = repair(readMeshFile(file)).mesh;
        SCOPED_TRACE(name);
        const LatticeFilling filling = fillingOf(mesh, LatticeKind::BodyCentred);
        EXPECT_EQ(narrowCrossings(mesh, filling).places, crossings);
        const FilledBody filled = fillBody(mesh, filling);
        expectSound(mesh, filled, filling);
        const Rigidity rigidity = rigidityOf(filled.nodes, filled.springs);
        EXPECT_EQ(rigidity.bodies, 1U);
        EXPECT_EQ(rigidity.floppyModes, 0U);
    }
}

TEST(FilledBody, LosesLittleOfAThinAndBentOrgan) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    const auto file = sharedData("meshes") / "colin27-lateral-ventricles-ascii.stl";
    ESM_SKIP_WITHOUT(file);
    const TriangleMesh mesh = repair(readMeshFile(file)).mesh;
    for (const auto& [kind, most] : {std::pair{LatticeKind::Cubic, 0.007},
                                     {LatticeKind::BodyCentred, 0.007},
                                     {LatticeKind::Graded, 0.007},
                                     {LatticeKind::Diamond, 0.01}})
        EXPECT_NEAR(volumeError(fillBody(mesh, fillingOf(mesh, kind, 40000))), 0, most) << wordOf(kind);
}

TEST(FilledBody, IsTheSameOnAnyNumberOfThreads) {
    const TriangleMesh mesh = lumpySurface(30, 60);
    const FilledBody many = fillBody(mesh, {LatticeKind::Graded, 0.008});
    const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
    const FilledBody one = fillBody(mesh, {LatticeKind::Graded, 0.008});
    EXPECT_EQ(many.nodes, one.nodes);
    EXPECT_EQ(many.tetrahedra, one.tetrahedra);
    ASSERT_EQ(many.springs.size(), one.springs.size());
    for (std::size_t i = 0; i < one.springs.size(); ++i)
        EXPECT_EQ(many.springs[i].constant, one.springs[i].constant);
}

TEST(FilledBody, TellsItsProgress) {
    test::expectGoodProgress([](const Progress& progress) {
        fillBody(lumpySurface(30, 60), {LatticeKind::BodyCentred, 0.01}, progress);
    });
}

std::string refusal(const TriangleMesh& mesh, const LatticeFilling& filling) {
    try {
        fillBody(mesh, filling);
    } catch (const InvalidModel& error) {
        EXPECT_EQ(error.problems().size(), 1U);
        return error.what();
    }
    return "";
}

TEST(FilledBody, RefusesWhatCannotBeFilled) {
    const TriangleMesh mesh = lumpySurface(30, 60);
    for (const double spacing :
         {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_THAT(refusal(mesh, {LatticeKind::Cubic, spacing}), HasSubstr("must be above 0 m"));
    EXPECT_THAT(refusal(mesh, {LatticeKind::Cubic, 1}),
                HasSubstr("a spacing of 1000 mm is wider than the organ"));
    const std::string tooFine = refusal(mesh, {LatticeKind::BodyCentred, 1e-4});
    EXPECT_THAT(tooFine, HasSubstr("million nodes and"));
    EXPECT_THAT(tooFine, HasSubstr("GB of memory"));
    for (const LatticeKind kind : stiffKinds) {
        const std::string text = refusal(mesh, {kind, 3e-4});
        const std::string::size_type number = text.find("of some ");
        ASSERT_NE(number, std::string::npos) << text;
        const double advised = std::stod(text.substr(number + 8)) / 1000;
        EXPECT_GT(estimateLattice(mesh, {kind, advised}).nodes, 0.7 * mostLatticeNodes) << text;
        EXPECT_LE(estimateLattice(mesh, {kind, advised}).nodes, mostLatticeNodes) << text;
    }
    EXPECT_THAT(refusal(flatSquare(1, 4), {LatticeKind::Cubic, 0.1}), HasSubstr("the surface is open"));
}

TEST(FilledBody, RefusesWidePlacesWhereTheSurfaceRunsThroughItself) {
    const TriangleMesh mesh = test::crossedBall();
    const std::string tooFine = refusal(mesh, {LatticeKind::BodyCentred, 0.03});
    EXPECT_THAT(tooFine, HasSubstr("the surface runs through itself"));
    const std::string::size_type number = tooFine.find("choose a spacing of ");
    ASSERT_NE(number, std::string::npos) << tooFine;
    const double enough = std::stod(tooFine.substr(number + 20)) / 1000;
    EXPECT_GT(enough, 0.03);
    EXPECT_EQ(narrowCrossings(mesh, {LatticeKind::BodyCentred, enough}).places, 1U);
    TriangleMesh balls = test::ball(1, {0, 0, 0});
    test::append(balls, test::ball(1, {1.1, 0.05, 0.02}));
    const std::string wide = refusal(balls, {LatticeKind::BodyCentred, 0.3});
    EXPECT_THAT(wide, HasSubstr("the surface runs through itself"));
    EXPECT_THAT(wide, testing::Not(HasSubstr("choose a spacing")));
    EXPECT_THAT(wide, HasSubstr("part or join them"));
}

TEST(LatticeEstimate, IsWithinAQuarterOfWhatComesOut) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    for (const TriangleMesh& mesh : {lumpySurface(30, 60), test::torus(), test::shell(1, 0.6)})
        for (const LatticeKind kind : stiffKinds)
            for (const double part : {15.0, 30.0}) {
                const LatticeFilling filling{kind, boundingBox(mesh.vertices).sizes().maxCoeff() / part};
                const LatticeEstimate estimate = estimateLattice(mesh, filling);
                const FilledBody filled = fillBody(mesh, filling);
                EXPECT_NEAR(estimate.nodes / static_cast<double>(filled.nodes.size()), 1, 0.25)
                    << wordOf(kind);
                EXPECT_NEAR(estimate.springs / static_cast<double>(filled.springs.size()), 1, 0.25)
                    << wordOf(kind);
                EXPECT_NEAR(estimate.tetrahedra / static_cast<double>(filled.tetrahedra.size()), 1, 0.25)
                    << wordOf(kind);
            }
}

TEST(LatticeEstimate, TellsItsProgress) {
    for (const TriangleMesh& mesh : {lumpySurface(30, 60), test::crossedBall()}) {
        const LatticeFilling filling{LatticeKind::BodyCentred,
                                     boundingBox(mesh.vertices).sizes().maxCoeff() / 15};
        test::expectSteadyProgress(
            [&](const Progress& progress) { estimateLattice(mesh, filling, progress); });
    }
}

TEST(LatticeEstimate, TellsTheCountOfWhatWouldBeRefused) {
    EXPECT_GT(estimateLattice(lumpySurface(30, 60), {LatticeKind::BodyCentred, 1e-4}).nodes, 1e8);
}

} // namespace
} // namespace esm
