#include "core/model/tissue_model.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// Two triangles over a unit square.
TriangleMesh square() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

TissueModel modelOf(SpringNetwork network) {
    TissueModel model;
    const std::size_t nodes = network.restPositions.size();
    model.network = std::make_shared<const SpringNetwork>(std::move(network));
    model.mass.assign(nodes, 0.1);
    model.springConstant.assign(nodes, 16);
    model.viscosity.assign(nodes, 3);
    model.tethers = {{0, 1, 1}};
    model.fixedNodes = {1, 3};
    return model;
}

} // namespace

TEST(SpringNetwork, HasANodePerVertexAndASpringPerEdge) {
    const SpringNetwork network = networkFromMesh(square());
    EXPECT_EQ(network.restPositions, square().vertices);
    EXPECT_THAT(network.vertexNodes, ElementsAre(0, 1, 2, 3));
    ASSERT_EQ(network.springs.size(), 5);
    for (const Spring& spring : network.springs) {
        const bool diagonal = spring.first == 0 && spring.second == 2;
        EXPECT_DOUBLE_EQ(spring.restLength, diagonal ? std::sqrt(2) : 1);
    }
}

TEST(SpringNetwork, ObeysEulersFormulaOnAClosedSurface) {
    const TriangleMesh octahedron{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    EXPECT_EQ(networkFromMesh(octahedron).springs.size(), 6 + 8 - 2);
}

TEST(TissueModel, GivesASpringTheMeanOfItsEnds) {
    TissueModel model = modelOf(networkFromMesh(square()));
    model.springConstant = {1, 2, 4, 8};
    model.viscosity = {10, 20, 40, 80};
    const auto [first, second, restLength] = model.network->springs[1];
    ASSERT_EQ(std::pair(first, second), std::pair(1U, 2U));
    EXPECT_EQ(valuesOf(model, 1).springConstant, 3);
    EXPECT_EQ(valuesOf(model, 1).viscosity, 30);
    EXPECT_FALSE(hasOwnValues(model));
}

TEST(TissueModel, GivesASpringWhatItHasOfItsOwn) {
    TissueModel model = modelOf(networkFromMesh(square()));
    const SpringValues means = valuesOf(model, 4);
    model.ownValues = springValues(model);
    EXPECT_FALSE(hasOwnValues(model));
    model.ownValues[4].viscosity *= 1 + 2e-6;
    EXPECT_TRUE(hasOwnValues(model));
    model.ownValues[4] = {3 * means.springConstant, means.viscosity / 3};
    EXPECT_EQ(valuesOf(model, 4).springConstant, 3 * means.springConstant);
    EXPECT_EQ(valuesOf(model, 4).viscosity, means.viscosity / 3);
    EXPECT_EQ(valuesOf(model, 3).springConstant, means.springConstant);
    EXPECT_THAT(validate(model), IsEmpty());
}

TEST(TissueModel, RefusesSpringsWhoseOwnValuesAreNone) {
    TissueModel model = modelOf(networkFromMesh(square()));
    model.stiffening = SpringStiffening{0.2, 5};
    model.ownValues = springValues(model);
    model.ownValues[1].springConstant = -1;
    model.ownValues[2].viscosity = NAN;
    model.ownValues[3].springConstant = 0.9e30;
    EXPECT_THAT(validate(model),
                ElementsAre(HasSubstr("2 springs with a spring constant or viscosity that is not 0 to 1e+30 "
                                      "(spring 1, 2)"),
                            HasSubstr("stretched springs that is not 0 to 1e+30 (spring 3)")));
    model.ownValues.resize(2);
    EXPECT_THAT(validate(model), testing::Contains(HasSubstr("2 springs have values of their own, of 5")));
}

TEST(TissueModel, ThatIsSoundHasNoProblem) {
    EXPECT_THAT(validate(modelOf(networkFromMesh(square()))), IsEmpty());
}

TEST(TissueModel, ReportsEveryKindOfProblemOnce) {
    SpringNetwork network = networkFromMesh(square());
    network.restPositions[0].x() = NAN;
    network.springs[1].second = 99;
    network.springs[2].second = network.springs[2].first;
    network.springs[3].restLength = -1;
    network.vertexNodes[2] = 4;
    TissueModel model = modelOf(network);
    model.mass = {0, -1, NAN, INFINITY};
    model.springConstant[1] = -1;
    model.viscosity.pop_back();
    model.tethers = {{7, 1, 1}, {1, -1, 0}};
    model.fixedNodes = {3, 3, 9};
    EXPECT_THAT(validate(model),
                ElementsAre(HasSubstr("node with a coordinate that is no number or beyond 1e+30 (node 0)"),
                            HasSubstr("does not exist (spring 1)"), HasSubstr("itself (spring 2)"),
                            HasSubstr("rest length that is not 0 to 1e+30 (spring 3)"),
                            HasSubstr("(mesh point 2)"), HasSubstr("viscosities has 3 entries for 4 nodes"),
                            HasSubstr("4 nodes with a mass that is not 1e-30 to 1e+30 (node 0, 1, 2, 3)"),
                            HasSubstr("spring constant that is not 0 to 1e+30 (node 1)"),
                            HasSubstr("(tether 0)"), HasSubstr("(tether 1)"), HasSubstr("(fixed node 2)"),
                            HasSubstr("(fixed node 1)")));
}

TEST(TissueModel, RefusesHingesThatAreNone) {
    TissueModel model = modelOf(networkFromMesh(square()));
    model.hinges = {{{0, 2, 1, 3}, 1, 1},  {{0, 2, 1, 4}, 1, 1},   {{0, 2, 1, 1}, 1, 1},
                    {{0, 2, 1, 3}, -1, 1}, {{0, 2, 1, 3}, 1, NAN}, {{0, 1, 2, 3}, 1, 1}};
    EXPECT_THAT(validate(model),
                ElementsAre(HasSubstr("does not exist (hinge 1)"), HasSubstr("twice (hinge 2)"),
                            HasSubstr("2 hinges with a stiffness or viscosity"),
                            HasSubstr("lie on each other (hinge 5)")));
}

TEST(TissueModel, IsBoundedSoThatNothingComputedFromItOverflows) {
    TissueModel model = modelOf(networkFromMesh(square()));
    const auto within = [&](double springConstant, double viscosity, double mass) {
        model.springConstant.assign(4, springConstant);
        model.viscosity.assign(4, viscosity);
        model.mass.assign(4, mass);
        return validate(model).empty();
    };
    EXPECT_TRUE(within(1e30, 1e30, 1e-30));
    EXPECT_EQ(valuesOf(model, 0).springConstant, 1e30);
    EXPECT_TRUE(within(0, 0, 1e30));
    EXPECT_FALSE(within(1.1e30, 1, 1));
    EXPECT_FALSE(within(1, 1e308, 1));
    EXPECT_FALSE(within(1, 1, 1e31));
    EXPECT_FALSE(within(1, 1, 1e-31));
}

TEST(TissueModel, RefusesABiphasicLawThatIsNone) {
    TissueModel model = modelOf(networkFromMesh(square()));
    const auto problems = [&](double strain, double factor) {
        model.stiffening = SpringStiffening{strain, factor};
        return validate(model);
    };
    EXPECT_THAT(problems(0.2, 5), IsEmpty());
    EXPECT_THAT(problems(9, 0.5), IsEmpty());
    for (const double none : std::vector<double>{0, -0.2, NAN, INFINITY, 1e31}) {
        EXPECT_THAT(problems(none, 5), ElementsAre(HasSubstr("the strain"))) << none;
        EXPECT_THAT(problems(0.2, none), ElementsAre(HasSubstr("the factor"))) << none;
    }
    EXPECT_THAT(problems(0.2, 1e29), ElementsAre(HasSubstr("4 nodes with a spring constant of stretched")));
}

TEST(TissueModel, WithoutNetworkOrNodesIsRefused) {
    EXPECT_THAT(validate(TissueModel{}), ElementsAre(HasSubstr("no network")));
    EXPECT_THAT(validate(modelOf({})), testing::Contains(HasSubstr("no nodes")));
}
