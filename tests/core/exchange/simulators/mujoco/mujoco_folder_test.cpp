#include "core/exchange/simulators/mujoco/mujoco_folder.h"

#include "core/exchange/project/scene_file.h"
#include "core/samples/organs.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/core/exchange/simulators/mujoco/mjcf_reader.h"
#include "tests/core/exchange/simulators/mujoco/mujoco_export.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/flat_wall_project.h"

namespace esm {
namespace {

class MujocoFolder : public MujocoExport {
protected:
    void expectSameTissue(const Project& project, Damping damping) {
        const MjcfReader model(exported(project, meansFor(damping)));
        const MovedTissue moved(project, damping, [&](std::size_t node) { return model.isMovable(node); });
        expectSameForces(model.forces(moved.at, moved.velocities), moved.forces);
    }

    std::string toldOf(const Project& project, const HandoverMeans& means = {}) {
        std::string text;
        for (const auto& [what, instead] : differencesOf(handoverOf(project), exporter(), means).list)
            text += what + "; " + instead + "\n";
        return text;
    }

    void expectRefused(const Project& project, const std::string& reason, const HandoverMeans& means = {}) {
        try {
            exported(project, means);
            ADD_FAILURE() << "it would be written";
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(reason));
        }
        EXPECT_FALSE(std::filesystem::exists(m_written));
    }
};

TEST_F(MujocoFolder, HasTheTissueOfSamples) {
    for (const char* name : {"tube", "uterus", "ventricle"})
        for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
            SCOPED_TRACE(name);
            expectSameTissue(makeSample(name), damping);
        }
}

TEST_F(MujocoFolder, HasTheTissueOfOrgansOfEveryKind) {
    for (const Project& project :
         {richProject(), bareProject(), filledProject(), latticeProject(), sheetProject(), flatWallProject(),
          biphasicProject(), boundProject({Detail::Kind::Nodes, 20}), boundProject({Detail::Kind::Rigid})})
        for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
            SCOPED_TRACE(project.name);
            expectSameTissue(project, damping);
        }
}

TEST_F(MujocoFolder, DampsPartsThatNothingHolds) {
    Project project = makeSample("tube");
    project.scene.tethers.clear();
    expectSameTissue(project, Damping::Isotropic);
    project.scene.fixed = {{{0, 1, 2}, std::nullopt}};
    expectSameTissue(project, Damping::Isotropic);
}

TEST_F(MujocoFolder, HasMassesPlacesAndWhatStandsStill) {
    Project project = makeSample("tube");
    project.scene.gravity = {0, -9.81, 0};
    project.scene.fixed = {{{3}, std::nullopt}};
    project.scene.moves = {{5, {{0.1, {0, 0, 0}}, {0.2, {0.01, 0, 0}}}}};
    const MjcfReader model(exported(project));
    EXPECT_EQ(model.positions(), project.network->restPositions);
    std::vector<double> masses;
    for (const MjcfElement* body : model.bodies())
        masses.push_back(body->only("inertial").number("mass"));
    EXPECT_EQ(masses, evaluateModel(project).mass);
    EXPECT_FALSE(model.isMovable(3));
    EXPECT_FALSE(model.bodies()[3]->has("mocap"));
    EXPECT_FALSE(model.isMovable(5));
    EXPECT_EQ(model.bodies()[5]->text("mocap"), "true");
    EXPECT_THAT(model.model().only("option").numbers("gravity"), testing::ElementsAre(0, -9.81, 0));
    const std::string scene = model.model().only("custom").only("text").text("data");
    EXPECT_EQ(sceneFromJson(nlohmann::ordered_json::parse(scene)), project.scene);
}

TEST_F(MujocoFolder, CarriesTheDrawnSurfaceByItsNodes) {
    const Project project = boundProject({Detail::Kind::Nodes, 20});
    const MjcfReader model(exported(project));
    std::size_t corners = 0;
    for (const MjcfElement* skin : model.model().only("asset").all("skin")) {
        std::vector<double> shares(skin->numbers("vertex").size() / 3, 0);
        for (const MjcfElement* bone : skin->all("bone")) {
            const std::vector<double> vertices = bone->numbers("vertid"),
                                      weights = bone->numbers("vertweight");
            for (std::size_t i = 0; i < vertices.size(); ++i)
                shares.at(static_cast<std::size_t>(vertices[i])) += weights.at(i);
        }
        EXPECT_THAT(shares, testing::Each(testing::DoubleNear(1, 1e-6)));
        corners += skin->numbers("face").size();
    }
    EXPECT_EQ(corners, 3 * project.mesh->triangles.size());
}

TEST_F(MujocoFolder, HasThePicturesOfTheTexture) {
    const MjcfReader model(exported(paintedProject()));
    const auto textures = model.model().only("asset").all("texture");
    ASSERT_FALSE(textures.empty());
    for (const MjcfElement* texture : textures)
        EXPECT_GT(std::filesystem::file_size(m_written / texture->text("file")), 0U);
    for (const MjcfElement* skin : model.model().only("asset").all("skin"))
        for (const double place : skin->numbers("texcoord"))
            EXPECT_TRUE(place >= 0 && place <= 1) << place;
    HandoverMeans jpeg;
    jpeg.pictures.format = PictureFormat::Jpeg;
    std::filesystem::remove_all(m_written);
    expectRefused(paintedProject(), "PNG", jpeg);
}

/// A strip that is led at both ends is held as one that is fixed there.
TEST_F(MujocoFolder, TakesLedNodesForHeld) {
    Project held = makeSample("tube");
    held.scene.tethers.clear();
    held.scene.fixed = {{{0, 1, 2, 3, 4, 5}, std::nullopt}};
    Project led = held;
    led.scene.fixed.clear();
    for (const std::uint32_t node : held.scene.fixed.front().nodes)
        led.scene.moves.push_back({node, {{0, {0, 0, 0}}, {1, {0.01, 0, 0}}}});
    const auto lagOf = [&](const Project& project) {
        const std::string text = toldOf(project, meansFor(Damping::Isotropic, 1e-3));
        return text.substr(0, text.find('\n'));
    };
    EXPECT_THAT(lagOf(held), testing::HasSubstr("comes later, up to"));
    EXPECT_EQ(lagOf(led), lagOf(held));
    const Differences ofLed = differencesOf(handoverOf(led), exporter()),
                      ofHeld = differencesOf(handoverOf(held), exporter());
    EXPECT_EQ(ofLed.largestStep, ofHeld.largestStep);
    EXPECT_EQ(ofLed.timeStep, ofHeld.timeStep);
    EXPECT_FALSE(ofLed.blowsUp());
}

TEST_F(MujocoFolder, NamesAreWrittenAsTheyAre) {
    Project project = bareProject();
    project.name = "a <b> & \"c\" für";
    EXPECT_EQ(MjcfReader(exported(project)).model().text("model"), project.name);
}

/// Undamped it is stepped at most as far as is stable; at a step that is too long it says so.
TEST_F(MujocoFolder, StepsWithinWhatIsStable) {
    const Project project = makeSample("tube");
    const MjcfReader model(exported(project));
    EXPECT_LE(model.model().only("option").number("timestep"), told.largestStep);
    EXPECT_THAT(toldOf(project), testing::HasSubstr("armature"));
    EXPECT_THAT(toldOf(project, meansFor(Damping::Isotropic, 1e-6)),
                testing::Not(testing::HasSubstr("armature")));
    EXPECT_FALSE(told.blowsUp());
    EXPECT_TRUE(differencesOf(handoverOf(project), exporter(), meansFor(Damping::Isotropic, 100)).blowsUp());
}

/// The published tube's motion is 0.9 % off by a lag of 3.5 ms.
TEST_F(MujocoFolder, CautionsWhereArmatureMakesMotionComeMuchLater) {
    const Handover handover = handoverOf(makeSample("tube"));
    EXPECT_EQ(differencesOf(handover, exporter()).caution, "");
    const Differences far = differencesOf(handover, exporter(), meansFor(Damping::Isotropic, 0.05));
    EXPECT_FALSE(far.blowsUp());
    EXPECT_THAT(far.caution, testing::HasSubstr("comes later"));
    EXPECT_TRUE(far.hasPoorStep());
}

TEST_F(MujocoFolder, TellsWhatMujocoDoesNot) {
    EXPECT_THAT(toldOf(biphasicProject()), testing::HasSubstr("2.3.1"));
    EXPECT_THAT(toldOf(makeSample("tube")), testing::HasSubstr("instruments"));
    EXPECT_THAT(toldOf(boundProject({Detail::Kind::Rigid})), testing::HasSubstr("does not turn"));
    EXPECT_THAT(toldOf(flatWallProject()), testing::Not(testing::HasSubstr("hinges")));
    Project project = makeSample("tube");
    project.scene.forces = {{1, {0, 0, 2}, 0.1, 0.3}};
    project.scene.moves = {{5, {{0.1, {0, 0, 0}}}}};
    EXPECT_THAT(toldOf(project),
                testing::AllOf(testing::HasSubstr("xfrc_applied"), testing::HasSubstr("mocap")));
    EXPECT_FALSE(std::filesystem::exists(m_written));
}

TEST_F(MujocoFolder, RefusesMoreNodesThanMujocoHasRoomFor) {
    TriangleMesh mesh;
    for (int i = 0; i < 2501; ++i)
        mesh.vertices.emplace_back(0.001 * i, i % 2, 0.01 * (i % 3));
    for (std::uint32_t i = 0; i + 2 < 2501; ++i)
        mesh.triangles.push_back({i, i + 1, i + 2});
    const Project project = makeProject("long", asImported(mesh));
    ASSERT_EQ(project.network->restPositions.size(), 2501U);
    expectRefused(project, "2501: import it again with a detail of 2500");
}

TEST_F(MujocoFolder, RefusesMassesThatMujocoTakesForNone) {
    Project project = bareProject();
    project.base.mass = 1e-20;
    project.regions.clear();
    expectRefused(project, "raise the mass");
}

} // namespace
} // namespace esm
