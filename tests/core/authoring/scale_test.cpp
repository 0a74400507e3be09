#include "core/authoring/scale.h"

#include "core/dynamics/simulation.h"
#include "core/model/tissue_digest.h"
#include "core/support/errors.h"
#include "core/texture/layers/composite.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/same_project.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace esm {
namespace {

/// With a stroke, landmarks and everything else that lies in an organ's space.
Project markedProject() {
    Project project = paintedProject();
    project.layers.front().landmarks = {{{3, 4}, {0.01, -0.02, 0.03}}};
    project.texture.atlas.texelsPerMetre = 1000;
    project.texture.occlusionReach = 0.01;
    return project;
}

// Twice and half as large are exact in binary numbers.
TEST(Scale, ThereAndBackIsTheSameProject) {
    for (const Project& project :
         {markedProject(), filledProject(), boundProject({Detail::Kind::Nodes, 20}), bareProject()})
        for (const KeptByScaling kept : {KeptByScaling::Mass, KeptByScaling::Density}) {
            expectSameProject(scaled(scaled(project, 2, kept), 0.5, kept), project);
            expectSameProject(scaled(project, 1, kept), project);
        }
}

TEST(Scale, TakesAllThatLiesInItsSpace) {
    const Project project = markedProject(), large = scaled(project, 2);
    for (std::size_t i = 0; i < project.mesh->vertices.size(); ++i)
        EXPECT_EQ(large.mesh->vertices[i], 2 * project.mesh->vertices[i]);
    for (std::size_t i = 0; i < project.network->springs.size(); ++i)
        EXPECT_EQ(large.network->springs[i].restLength, 2 * project.network->springs[i].restLength);
    for (std::size_t i = 0; i < project.regions.size(); ++i) {
        EXPECT_EQ(large.regions[i].rim, 2 * project.regions[i].rim);
        if (project.regions[i].ellipsoid) {
            EXPECT_EQ(large.regions[i].ellipsoid->radii, 2 * project.regions[i].ellipsoid->radii);
        }
        EXPECT_EQ(countOf(*large.network, large.regions[i]).nodes,
                  countOf(*project.network, project.regions[i]).nodes);
    }
    EXPECT_EQ(radiusOf(large.scene.instruments[0].shape), 2 * radiusOf(project.scene.instruments[0].shape));
    EXPECT_EQ(scaled(Capsule{0.25, 4}, 2), Collider(Capsule{0.5, 8}));
    EXPECT_EQ(large.scene.moves[0].path[1].value, 2 * project.scene.moves[0].path[1].value);
    EXPECT_EQ(large.scene.gravity, project.scene.gravity);
    EXPECT_EQ(large.scene.forces[0].force, project.scene.forces[0].force);
    EXPECT_EQ(large.layers[0].landmarks[0].organ, 2 * project.layers[0].landmarks[0].organ);
    EXPECT_EQ(large.layers[0].landmarks[0].photo, project.layers[0].landmarks[0].photo);
    EXPECT_EQ(large.texture.atlas.texelsPerMetre, 500);
    EXPECT_EQ(large.texture.occlusionReach, 0.02);
    EXPECT_EQ(large.atlas->texelsPerMetre, project.atlas->texelsPerMetre / 2);
}

TEST(Scale, LeavesTheTextureAsItLooks) {
    const Project project = markedProject(), large = scaled(project, 2);
    const auto pages = [](const Project& p) {
        return composite(*p.mesh, *p.atlas, p.layers, p.texture.baseColour);
    };
    const std::vector<Image> before = pages(project), after = pages(large);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t page = 0; page < before.size(); ++page)
        EXPECT_EQ(before[page].pixels, after[page].pixels);
}

/// Springs' forces grow with their lengths: under forces as many times as large the motion is as many times
/// as large, where nothing but length changed.
TEST(Scale, MovesAlikeUnderForcesThatAreScaledToo) {
    const Project project = richProject();
    const TissueModel tissue = evaluateModel(project), large = evaluateModel(scaled(project, 2));
    SimulationSettings settings;
    settings.integrator = Integrator::Rk4;
    settings.timeStep = 1e-4;
    Simulation small(tissue, settings), big(large, settings);
    Loads load, twice;
    load.forces = {{4, {0.01, 0, -0.02}}};
    twice.forces = {{4, {0.02, 0, -0.04}}};
    for (int step = 0; step < 50; ++step) {
        ASSERT_TRUE(small.step(load));
        ASSERT_TRUE(big.step(twice));
    }
    EXPECT_NE(small.positions()[4], tissue.network->restPositions[4]);
    for (std::size_t i = 0; i < small.positions().size(); ++i)
        EXPECT_EQ(big.positions()[i], 2 * small.positions()[i]);
}

TEST(Scale, KeepsMassOrDensity) {
    const Project project = richProject();
    const auto massOf = [](const Project& p) {
        const TissueModel tissue = evaluateModel(p);
        return std::accumulate(tissue.mass.begin(), tissue.mass.end(), 0.0);
    };
    EXPECT_EQ(massOf(scaled(project, 2)), massOf(project));
    EXPECT_EQ(evaluateModel(scaled(project, 2)).springConstant, evaluateModel(project).springConstant);
    const Project dense = scaled(project, 2, KeptByScaling::Density);
    EXPECT_EQ(dense.base.mass, 8 * project.base.mass);
    for (std::size_t i = 0; i < project.regions.size(); ++i)
        if (project.regions[i].held.mass) {
            EXPECT_EQ(*dense.regions[i].held.mass, 8 * *project.regions[i].held.mass);
        }
    EXPECT_EQ(dense.base.springConstant, project.base.springConstant);
}

TEST(Scale, KeepsTheFirmnessOfWhatFillsTheOrgan) {
    const Project filled = filledProject(), large = scaled(filled, 2);
    EXPECT_EQ(large.network->lattice->filling.spacing, 2 * filled.network->lattice->filling.spacing);
    const std::vector<SpringValues> before = springValues(evaluateModel(filled)),
                                    after = springValues(evaluateModel(large));
    // Of one modulus a lattice's constants grow with its spacing.
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_NEAR(after[i].springConstant, 2 * before[i].springConstant, 1e-9 * before[i].springConstant);
}

TEST(Scale, MarksAMeasuredSteppingAsFromOtherTissue) {
    Project project = richProject();
    for (const std::string& tissue : {std::string(), tissueDigest(evaluateModel(project))}) {
        project.stepping->tissue = tissue;
        EXPECT_FALSE(isFromOtherTissue(*project.stepping, evaluateModel(project)));
        const Project large = scaled(project, 1.01);
        EXPECT_TRUE(isFromOtherTissue(*large.stepping, evaluateModel(large)));
    }
}

TEST(Scale, RefusesWhatIsNoSize) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double factor : {0.0, -1.0, infinite, std::nan(""), 1e300, 1e-300})
        EXPECT_THROW(scaled(markedProject(), factor), InvalidModel) << factor;
    EXPECT_EQ(scaleFactor({0, 0, 0}, {0, 0.02, 0}, 0.05), 2.5);
    EXPECT_THROW(scaleFactor({1, 0, 0}, {1, 0, 0}, 0.05), InvalidModel);
    EXPECT_THROW(scaleFactor({0, 0, 0}, {1, 0, 0}, -1), InvalidModel);
}

} // namespace
} // namespace esm
