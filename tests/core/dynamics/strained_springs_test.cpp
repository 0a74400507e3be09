#include "core/dynamics/strained_springs.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using tissue::Vectors;

namespace {

constexpr int links = 20;
constexpr double lawStrain = 0.2;

SpringSystem chain() {
    SpringNetwork network;
    for (int i = 0; i <= links; ++i)
        network.restPositions.emplace_back(0.01 * i, 0, 0);
    for (std::size_t i = 0; i < links; ++i)
        tissue::addSpring(network, i, i + 1);
    TissueModel model = tissue::model(std::move(network), {});
    model.stiffening = SpringStiffening{lawStrain, 10};
    return makeSpringSystem(model);
}

/// Each link strained more than the one before, the last twice as much as the first.
Vectors drawnOut(double strain) {
    Vectors positions{{0, 0, 0}};
    for (int i = 0; i < links; ++i)
        positions.push_back(positions.back() +
                            Eigen::Vector3d(0.01 * (1 + strain * (1 + i / (links - 1.0))), 0, 0));
    return positions;
}

int stiffLinks(const StrainedSprings& strained, const SpringSystem& system) {
    int count = 0;
    for (const auto& spring : strained.linearised(system).springs)
        count += spring.springConstant > system.springs.front().springConstant;
    return count;
}

} // namespace

TEST(StrainedSprings, AreTakenInByManyAtATimeAndLetGo) {
    const SpringSystem system = chain();
    StrainedSprings strained(system);
    int changes = 0;
    for (int i = 0; i <= 100; ++i) {
        changes += strained.follow(system, drawnOut(0.01 * i * lawStrain * 1.01));
        EXPECT_EQ(stiffLinks(strained, system) > 0, i > 49) << i;
    }
    EXPECT_EQ(stiffLinks(strained, system), links);
    EXPECT_LE(changes, 5);
    EXPECT_TRUE(strained.follow(system, drawnOut(0)));
    EXPECT_EQ(stiffLinks(strained, system), 0);
}
