#include "core/model/gentle_pull.h"
#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;

TEST(GentlePull, DrawsThePatchOutwardsThatLiesTheFarthestOut) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(31, 0.1), {});
    const auto pull = gentlePull(model);
    ASSERT_TRUE(pull);
    EXPECT_EQ(pull->node, model.mass.size() - 1);
    EXPECT_GT(pull->furthest.dot(model.network->restPositions.back()), 0);
    EXPECT_THAT(graspedNodes(model, pull->node), testing::UnorderedElementsAre(960, 959, 929, 928));
    model.fixedNodes = {959, 960};
    EXPECT_EQ(gentlePull(model)->node, 929U);
    EXPECT_THAT(graspedNodes(model, 929), testing::Not(testing::Contains(960)));
}

TEST(GentlePull, MovesASceneInWhichNothingDoes) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(5, 0.1), {});
    Scene scene;
    scene.fixed = {{{0}, {}}};
    EXPECT_FALSE(movesTissue(scene));
    const Scene pulled = withGentlePull(model, scene);
    EXPECT_TRUE(movesTissue(pulled));
    EXPECT_THAT(validate(pulled, model.mass.size()), testing::IsEmpty());
    EXPECT_EQ(pulled.fixed.size(), 1U);
    for (std::uint32_t node = 0; node < model.mass.size(); ++node)
        model.fixedNodes.push_back(node);
    EXPECT_FALSE(gentlePull(model));
    EXPECT_THROW(withGentlePull(model, scene), InvalidModel);
}

TEST(GentlePull, IsNotNeededWhereALoadOrAnInstrumentMovesTheTissue) {
    Scene falling, pushed, touched, led;
    falling.gravity = {0, 0, -9.81};
    pushed.forces = {{0, {0, 0, 1}, 0, 1}};
    touched.instruments = {{Sphere{0.01}, {{0, {0, 0, 0}}}, {}, {}}};
    led.moves = {{0, {{0, {0, 0, 0}}}}};
    for (const Scene& scene : {falling, pushed, touched, led})
        EXPECT_TRUE(movesTissue(scene));
}
