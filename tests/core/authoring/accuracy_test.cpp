#include "core/authoring/accuracy.h"

#include "core/samples/samples.h"
#include "core/support/errors.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(Accuracy, PullsAtTheEdgeWhereTheSceneMovesNothing) {
    Project tube = makeSample("tube");
    EXPECT_TRUE(measuredScene(tube).moves.empty());
    tube.scene.instruments.clear();
    const Scene pulled = measuredScene(tube);
    EXPECT_FALSE(pulled.moves.empty());
    EXPECT_TRUE(validate(pulled, tube.network->restPositions.size()).empty());
    NodeSelection all;
    for (std::uint32_t node = 0; node < tube.network->restPositions.size(); ++node)
        all.nodes.push_back(node);
    tube.scene.fixed = {all};
    EXPECT_THROW(measuredScene(tube), InvalidModel);
}
