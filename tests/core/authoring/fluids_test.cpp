#include "core/authoring/fluids.h"

#include "core/model/scene_cavities.h"
#include "core/project/detail_change.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace esm;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

/// A ball of 3 cm, one of 1 cm beside it, and a third that lacks a triangle.
Project threeBalls() {
    RepairedMesh surface;
    for (const double radius : {0.03, 0.01, 0.02}) {
        const TriangleMesh ball = tissue::sphereMesh(2, radius);
        const auto first = static_cast<std::uint32_t>(surface.mesh.vertices.size());
        for (const Eigen::Vector3d& vertex : ball.vertices)
            surface.mesh.vertices.push_back(vertex + Eigen::Vector3d(100 * radius, 0, 0));
        for (const Triangle& triangle : ball.triangles)
            surface.mesh.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
    }
    surface.mesh.triangles.pop_back();
    return makeProject("balls", std::move(surface));
}

double volumeOfBall(double radius) {
    return 4 * std::numbers::pi / 3 * std::pow(radius, 3);
}

} // namespace

TEST(Fluids, AreForPartsThatAreClosed) {
    const Project balls = threeBalls();
    const std::vector<FillablePart> parts = fillableParts(*balls.mesh, *balls.network);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_NEAR(parts[0].volume, volumeOfBall(0.03), 0.1 * volumeOfBall(0.03));
    EXPECT_NEAR(parts[1].volume, volumeOfBall(0.01), 0.1 * volumeOfBall(0.01));
    EXPECT_EQ(parts[0].problem + parts[1].problem, "");
    EXPECT_EQ(parts[2].volume, 0);
    EXPECT_THAT(parts[2].problem, StartsWith(" is open, and a fluid would run out: 3 open edges"));
    for (const FillablePart& part : parts) {
        const auto cavity = [&] { cavityOf(balls.network->restPositions, balls.mesh->triangles, part.part); };
        if (part.problem.empty())
            EXPECT_NO_THROW(cavity());
        else
            EXPECT_THROW(cavity(), InvalidModel);
    }
}

TEST(Fluids, HaveNoRoomInALatticeNorInWhatIsRigid) {
    const Project liver = makeSample("liver");
    EXPECT_EQ(whyNoFluid(liver), "");
    const Detail filled{Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::BodyCentred, 0.02}};
    EXPECT_THAT(whyNoFluid(withDetail(liver, filled)), HasSubstr("lattice"));
    EXPECT_THAT(whyNoFluid(withDetail(liver, {Detail::Kind::Rigid, 0, {}})), HasSubstr("stiff piece"));
}

TEST(Fluids, AreAsStiffAsTheirWallCanPress) {
    const double volume = volumeOfBall(0.03);
    const double most = std::numbers::sqrt3 * 16 / (2 * 0.03);
    const double stiffness = usualFluidStiffness(16, volume);
    EXPECT_GE(stiffness, 1000 * most);
    EXPECT_LE(stiffness, 2500 * most);
    EXPECT_EQ(stiffness, 5e5);
    EXPECT_GT(usualFluidStiffness(0, volume), 0);
    EXPECT_GT(usualFluidStiffness(1e-12, volume), 0);
}

TEST(Fluids, TakeThePlaceOfWhatIsThere) {
    Project balls = threeBalls();
    fillPart(balls, 1, 1000);
    fillPart(balls, 0, 2000);
    fillPart(balls, 1, 3000);
    EXPECT_EQ(balls.scene.fillings, (std::vector<FluidFilling>{{1, 3000}, {0, 2000}}));
    balls.scene.pressures = {{0, {{0, 0}, {1, 500}}}};
    pressPart(balls, 1, 700);
    EXPECT_FALSE(isConstant(*pressureOf(balls.scene, 0)));
    pressPart(balls, 0, 900);
    EXPECT_EQ(balls.scene.pressures, (std::vector<PartPressure>{{0, {{0, 900}}}, {1, {{0, 700}}}}));
    EXPECT_EQ(validate(balls), std::vector<std::string>());
    EXPECT_EQ(fluidParts(balls.scene), (std::vector<std::uint32_t>{0, 1}));
    fillPart(balls, 1, std::nullopt);
    pressPart(balls, 0, 0);
    EXPECT_EQ(fluidOf(balls.scene, 1), nullptr);
    EXPECT_EQ(pressureOf(balls.scene, 0), nullptr);
    EXPECT_EQ(fluidOf(balls.scene, 0)->stiffness, 2000);
    removeFluids(balls.scene);
    EXPECT_TRUE(fluidParts(balls.scene).empty());
}

TEST(Fluids, AreMissedInTheWordsOfTheOrganWhereItsDetailChanges) {
    Project liver = makeSample("liver");
    fillPart(liver, 0, 1e5);
    const auto refused = [&](const Detail& detail) -> std::string {
        try {
            withDetail(liver, detail);
        } catch (const InvalidModel& problem) {
            return problem.what();
        }
        return {};
    };
    EXPECT_THAT(refused({Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::BodyCentred, 0.02}}),
                StartsWith("a lattice fills this organ, and leaves no room for a fluid"));
    EXPECT_THAT(refused({Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Prisms, 0, 0.003, 2}}),
                StartsWith("within a wall of prisms a fluid is not computed yet; make the organ hollow"));
}
