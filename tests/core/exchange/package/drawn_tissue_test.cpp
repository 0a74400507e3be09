#include "core/exchange/package/drawn_tissue.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::ElementsAre;

/// Three nodes, of which the last never moves.
TissueModel threeNodes(std::optional<Binding> binding, std::vector<std::uint32_t> vertexNodes) {
    SpringNetwork network;
    network.restPositions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    network.vertexNodes = std::move(vertexNodes);
    network.binding = std::move(binding);
    TissueModel tissue;
    tissue.network = std::make_shared<const SpringNetwork>(network);
    tissue.mass = {1, 2, 4};
    tissue.springConstant = {10, 20, 40};
    tissue.viscosity = {0.5, 0.25, 0};
    tissue.fixedNodes = {2};
    return tissue;
}

TEST(DrawnTissue, IsThatOfTheNodeThatCarriesAVertex) {
    const DrawnTissue drawn = drawnTissue(threeNodes(std::nullopt, {2, 0}), 2);
    EXPECT_THAT(drawn.mass, ElementsAre(4, 1));
    EXPECT_THAT(drawn.springConstant, ElementsAre(40, 10));
    EXPECT_THAT(drawn.viscosity, ElementsAre(0, 0.5));
    EXPECT_THAT(drawn.fixed, ElementsAre(1, 0));
}

TEST(DrawnTissue, IsTheMeanOfSeveralNodesAndNeverBeyondThem) {
    const Binding binding{{}, {}, {{0, 2, 4}, {0, 2, 0, 1}, {0.75, 0.25, 1.5, -0.5}}};
    const DrawnTissue drawn = drawnTissue(threeNodes(binding, {0, 0}), 2);
    EXPECT_THAT(drawn.mass, ElementsAre(1.75, 1));
    EXPECT_THAT(drawn.springConstant, ElementsAre(17.5, 10));
    EXPECT_THAT(drawn.fixed, ElementsAre(0.25, 0));
}

TEST(DrawnTissue, IsOfNodesWhereThereIsNoSurface) {
    const DrawnTissue drawn = drawnTissue(threeNodes(std::nullopt, {}), 0);
    EXPECT_THAT(drawn.mass, ElementsAre(1, 2, 4));
    Glb glb;
    GltfArrays arrays(glb);
    nlohmann::ordered_json attributes;
    addTissueAttributes(drawn, {0, 1, 2}, arrays, attributes);
    EXPECT_FALSE(attributes.contains("_ESM_VERTEX"));
    EXPECT_TRUE(attributes.contains("_ESM_FIXED"));
}

TEST(DrawnTissue, NamesTheVertexOfEachPlaceInTheTexture) {
    Glb glb;
    GltfArrays arrays(glb);
    nlohmann::ordered_json attributes;
    addTissueAttributes(drawnTissue(threeNodes(std::nullopt, {2, 0}), 2), {1, 0, 1}, arrays, attributes);
    std::vector<std::string> problems;
    const GltfArrayReader reader(glb, problems);
    const auto values = [&](const char* name) {
        return reader.floats(JsonReader(attributes[name], name, problems), GltfType::Scalar, 3);
    };
    EXPECT_THAT(values("_ESM_VERTEX"), ElementsAre(1, 0, 1));
    EXPECT_THAT(values("_ESM_MASS"), ElementsAre(1, 4, 1));
    EXPECT_THAT(problems, testing::IsEmpty());
}

} // namespace
} // namespace esm
