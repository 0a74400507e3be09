#include "core/exchange/simulators/sofa/sofa_folder.h"

#include "core/dynamics/forces.h"
#include "core/exchange/simulators/exporters.h"
#include "core/samples/samples.h"
#include "tests/core/exchange/simulators/sofa/sofa_reader.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/flat_wall_project.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

namespace esm {
namespace {

const Exporter& sofaExporter() {
    return exporterFor("organ.sofa");
}

HandoverMeans meansFor(SofaVersion version, Damping damping = Damping::Isotropic) {
    HandoverMeans means;
    means.engine = {.timeStep = 0.002, .damping = damping, .sofaVersion = version};
    return means;
}

Vectors scattered(const Vectors& around, double by, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(-by, by);
    Vectors places = around;
    for (Eigen::Vector3d& place : places)
        place += Eigen::Vector3d(share(random), share(random), share(random));
    return places;
}

double largest(const Vectors& vectors) {
    double size = 0;
    for (const Eigen::Vector3d& vector : vectors)
        size = std::max(size, vector.norm());
    return size;
}

double largestGap(const Vectors& a, const Vectors& b) {
    Vectors gaps = a;
    for (std::size_t i = 0; i < gaps.size(); ++i)
        gaps[i] -= b.at(i);
    return largest(gaps);
}

class SofaFolder : public testing::Test {
protected:
    SofaReader exported(const Project& project, const HandoverMeans& means = {}) {
        std::filesystem::remove_all(m_written);
        exportProject(project, sofaExporter(), m_written, means);
        return SofaReader(m_written);
    }

    /// The scene's forces and damping, at places and speeds that organs come to, are the model's.
    void expectSameTissue(const Project& project, const HandoverMeans& means) {
        const SofaReader scene = exported(project, means);
        const TissueModel tissue = evaluateModel(project);
        const SpringSystem system = makeSpringSystem(tissue);
        const Vectors rest = tissue.network->restPositions;
        const double size = organBox(*project.mesh, *project.network).diagonal().norm();
        const Vectors at = scattered(rest, 0.02 * size, 1);
        const Vectors still(rest.size(), Eigen::Vector3d::Zero()), moving = scattered(still, size, 2);
        Vectors elastic(rest.size()), damping = still;
        elasticForces(system, at, elastic);
        addDampingForces(system, means.engine.damping, at, moving, damping);
        ASSERT_GT(largest(elastic), 0);
        EXPECT_LT(largestGap(scene.forces(at, still), elastic), 1e-7 * largest(elastic));
        Vectors both = elastic;
        addDampingForces(system, means.engine.damping, at, moving, both);
        EXPECT_LT(largestGap(scene.forces(at, moving), both), 1e-7 * largest(both));
        if (means.engine.damping == Damping::Isotropic) {
            EXPECT_LT(largestGap(scene.solvedDamping(moving), damping), 1e-9 * largest(damping));
        }
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_written = m_folder / "organ.sofa";
};

TEST_F(SofaFolder, HasTheTissueOfSamplesForEveryRelease) {
    for (const std::string& name : sampleNames())
        for (const auto& [version, word] : wordsOf<SofaVersion>) {
            SCOPED_TRACE(name + " " + word);
            expectSameTissue(makeSample(name), meansFor(version));
        }
}

TEST_F(SofaFolder, HasTheTissueOfOrgansOfEveryKind) {
    for (const Project& project :
         {richProject(), bareProject(), filledProject(), latticeProject(), sheetProject(), flatWallProject(),
          biphasicProject(), boundProject({Detail::Kind::Nodes, 20}), boundProject({Detail::Kind::Rigid})})
        for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
            SCOPED_TRACE(project.name);
            expectSameTissue(project, meansFor(SofaVersion::June2026, damping));
        }
}

TEST_F(SofaFolder, DampsAWallThatBendsInEarlyReleases) {
    ASSERT_FALSE(evaluateModel(flatWallProject()).hinges.empty());
    expectSameTissue(flatWallProject(), meansFor(SofaVersion::June2024));
    expectSameTissue(flatWallProject(), meansFor(SofaVersion::June2024, Damping::Axial));
}

TEST_F(SofaFolder, NamesComponentsAsTheReleaseDoes) {
    Project project = richProject();
    project.scene.fixed = {{{0, 1}, std::nullopt}};
    project.scene.moves = {{5, {{0.1, {0, 0, 0}}, {0.2, {0.01, 0, 0}}}}};
    const SofaReader early = exported(project, meansFor(SofaVersion::December2023));
    EXPECT_THAT(early.only("FixedConstraint").numbers("indices"), testing::ElementsAre(0, 1));
    EXPECT_EQ(early.all("LinearMovementConstraint").size(), 1U);
    EXPECT_EQ(early.all("StiffSpringForceField").size(), 1U);
    const SofaReader middle = exported(project, meansFor(SofaVersion::June2024));
    EXPECT_EQ(middle.all("FixedProjectiveConstraint").size(), 1U);
    EXPECT_EQ(middle.all("StiffSpringForceField").size(), 1U);
    const SofaReader late = exported(project, meansFor(SofaVersion::December2024));
    EXPECT_EQ(late.all("LinearMovementProjectiveConstraint").size(), 1U);
    EXPECT_EQ(late.all("SpringForceField").size(), 1U);
}

TEST_F(SofaFolder, HasMassesAndThePlaceOfEveryNode) {
    const Project project = makeSample("tube");
    const SofaReader scene = exported(project);
    EXPECT_EQ(scene.only("DiagonalMass").numbers("vertexMass"), evaluateModel(project).mass);
    EXPECT_EQ(scene.positions(), project.network->restPositions);
    EXPECT_EQ(scene.only("TriangleSetTopologyContainer").numbers("triangles").size(),
              3 * project.mesh->triangles.size());
}

/// DiagonalMass says "Topology empty" of points without cells.
TEST_F(SofaFolder, OrgansWithoutASurfaceHaveTheirSpringsAsCells) {
    const Project project = makeSample("uterus");
    const SofaReader scene = exported(project);
    EXPECT_EQ(scene.positions(), project.network->restPositions);
    EXPECT_EQ(scene.only("EdgeSetTopologyContainer").numbers("edges").size(),
              2 * project.network->springs.size());
}

TEST_F(SofaFolder, ForcesAndLedNodesKeepTheirTimes) {
    Project project = bareProject();
    project.scene.fixed.clear();
    project.scene.gravity = {0, -9.81, 0};
    project.scene.forces = {{1, {0, 0, 2}, 0.1, 0.3}};
    project.scene.moves = {{0, {{0.2, {0.01, 0, 0}}, {0.4, {0, 0.02, 0}}}}};
    const SofaReader scene = exported(project, meansFor(SofaVersion::June2026));
    EXPECT_THAT(scene.elements().front().numbers("gravity"), testing::ElementsAre(0, -9.81, 0));
    const SofaElement& force = scene.only("LinearForceField");
    EXPECT_THAT(force.numbers("points"), testing::ElementsAre(1));
    EXPECT_THAT(force.numbers("forces"), testing::ElementsAre(0, 0, 2, 0, 0, 2, 0, 0, 0));
    // The step that begins there, and not the one behind it: within a hundredth of a step.
    const std::vector<double> times = force.numbers("times");
    EXPECT_THAT(
        times, testing::Each(testing::AnyOf(testing::DoubleNear(0.1, 2e-5), testing::DoubleNear(0.3, 2e-5))));
    EXPECT_LT(times[0], 0.1);
    EXPECT_LT(times[1], 0.3);
    const SofaElement& move = scene.only("LinearMovementProjectiveConstraint");
    EXPECT_THAT(move.numbers("movements"),
                testing::ElementsAre(0.01, 0, 0, 0.01, 0, 0, 0, 0.02, 0, 0, 0.02, 0));
    // A step earlier: SOFA ends a step with where the path is at its begin.
    const double step = scene.elements().front().numbers("dt").front();
    EXPECT_THAT(move.numbers("keyTimes"),
                testing::ElementsAre(-step, testing::DoubleEq(0.2 - step), testing::DoubleEq(0.4 - step),
                                     testing::Gt(1e8)));
}

TEST_F(SofaFolder, HasTheDrawnSurfaceWithItsTexture) {
    const Project project = paintedProject();
    const SofaReader scene = exported(project);
    EXPECT_EQ(scene.only("MeshOBJLoader").text("filename"), "surface.obj");
    for (const char* file : {"surface.obj", "surface.mtl", "texture-1.png"})
        EXPECT_GT(std::filesystem::file_size(m_written / file), 0U) << file;
    exported(bareProject());
    EXPECT_FALSE(std::filesystem::exists(m_written / "surface.obj"));
}

TEST_F(SofaFolder, StepsAxialDampingWithinItsLimit) {
    HandoverMeans means;
    means.engine.damping = Damping::Axial;
    const SofaReader scene = exported(makeSample("tube"), means);
    const double step = scene.elements().front().numbers("dt").front();
    const Differences told = differencesOf(handoverOf(makeSample("tube")), sofaExporter(), means);
    EXPECT_EQ(told.timeStep, step);
    EXPECT_LT(step, told.largestStep);
    EXPECT_GT(step, 0.5 * told.largestStep);
    EXPECT_EQ(scene.all("CGLinearSolver").size(), 0U);
}

TEST_F(SofaFolder, TellsWhatSofaDoesNot) {
    const auto told = [&](const Project& project, SofaVersion version) {
        std::string text;
        for (const auto& [what, instead] :
             differencesOf(handoverOf(project), sofaExporter(), meansFor(version)).list)
            text += what + "; " + instead + "\n";
        return text;
    };
    Project untouched = makeSample("liver");
    untouched.scene.instruments.clear();
    EXPECT_THAT(told(untouched, SofaVersion::June2026), testing::HasSubstr("nothing moves the organ"));
    untouched.scene.gravity = {0, 0, -9.81};
    EXPECT_EQ(told(untouched, SofaVersion::June2026), "");
    EXPECT_THAT(told(biphasicProject(), SofaVersion::June2024), testing::HasSubstr("24.12"));
    EXPECT_THAT(told(biphasicProject(), SofaVersion::December2024),
                testing::Not(testing::HasSubstr("24.12")));
    EXPECT_THAT(told(makeSample("tube"), SofaVersion::June2026), testing::HasSubstr("instrument"));
    EXPECT_THAT(told(boundProject({Detail::Kind::Rigid}), SofaVersion::June2026),
                testing::HasSubstr("left out"));
    EXPECT_THAT(told(boundProject({Detail::Kind::Nodes, 20}), SofaVersion::June2026),
                testing::HasSubstr("flat"));
    EXPECT_FALSE(std::filesystem::exists(m_written));
}

TEST_F(SofaFolder, ThatHoldsSomethingStaysAsItIs) {
    std::filesystem::create_directory(m_written);
    std::ofstream(m_written / "notes.txt") << "mine";
    try {
        exportProject(bareProject(), sofaExporter(), m_written);
        ADD_FAILURE() << "it would mix with what is there";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("not empty"));
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(m_folder.path()), {}), 1);
    std::filesystem::remove(m_written / "notes.txt");
    exportProject(bareProject(), sofaExporter(), m_written);
    EXPECT_TRUE(std::filesystem::exists(m_written / "organ.scn"));
}

} // namespace
} // namespace esm
