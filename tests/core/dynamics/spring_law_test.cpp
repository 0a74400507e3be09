#include "core/dynamics/forces.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector3d;

namespace {

constexpr double restLength = 2;
constexpr SecondPhase stiffAfterAQuarter{0.25, 50};

SpringSystem biphasicSpring() {
    SpringSystem system = makeSpringSystem(tissue::oneSpring({10, 0, 1}, restLength));
    system.springs[0].secondPhase = stiffAfterAQuarter;
    return system;
}

double tensionAt(double length) {
    Vectors forces;
    elasticForces(biphasicSpring(), {{0, 0, 0}, {length, 0, 0}}, forces);
    EXPECT_EQ(forces[0], Vector3d(-forces[1]));
    return forces[0].x();
}

} // namespace

TEST(SpringLaw, IsStifferBeyondItsStrainOnly) {
    EXPECT_DOUBLE_EQ(tensionAt(1), -10);
    EXPECT_DOUBLE_EQ(tensionAt(2), 0);
    EXPECT_DOUBLE_EQ(tensionAt(2.5), 5);
    EXPECT_DOUBLE_EQ(tensionAt(3), 5 + 50 * 0.5);
}

TEST(SpringLaw, OfATissueHoldsForEachOfItsSpringsAndForNoTether) {
    TissueModel model = tissue::fallopianTube();
    model.springConstant[0] = 40;
    model.stiffening = SpringStiffening{0.2, 5};
    const SpringSystem system = makeSpringSystem(model);
    for (const auto& spring : system.springs) {
        EXPECT_EQ(spring.secondPhase.strain, 0.2);
        EXPECT_EQ(spring.secondPhase.springConstant, 5 * spring.springConstant);
        EXPECT_EQ(largestSpringConstant(spring), 5 * spring.springConstant);
    }
    EXPECT_EQ(system.tethers[0].springConstant, model.tethers[0].springConstant);
    model.stiffening.reset();
    EXPECT_TRUE(makeSpringSystem(model).springs[0].secondPhase.isLinear());
}

TEST(SpringLaw, HasNoJump) {
    EXPECT_NEAR(tensionAt(2.5 * (1 - 1e-9)), tensionAt(2.5 * (1 + 1e-9)), 1e-6);
}

TEST(SpringLaw, MayBecomeSofter) {
    EXPECT_DOUBLE_EQ(tensionPerLength(10, {0.25, 4}, 2.0 / 3) * 3, 5 + 4 * 0.5);
}

TEST(SpringLaw, WithoutAStrainIsLinearWhateverTheOtherConstant) {
    const SecondPhase none{std::numeric_limits<double>::infinity(), 1e9};
    EXPECT_EQ(tensionPerLength(10, none, 0.5), 5);
    EXPECT_EQ(tensionPerLength(10, none, 0), 10);
    EXPECT_EQ(elasticEnergy(10, none, 0, 3), 45);
}

TEST(SpringLaw, EnergyIsWhatTheForceDid) {
    const SpringSystem system = biphasicSpring();
    const Vectors still(2, Vector3d::Zero());
    constexpr double step = 1e-6;
    for (const double length : {0.5, 1.9, 2.3, 2.7, 8.0}) {
        const auto energyAt = [&](double x) { return energy(system, {{0, 0, 0}, {x, 0, 0}}, still).elastic; };
        EXPECT_NEAR((energyAt(length + step) - energyAt(length - step)) / (2 * step), tensionAt(length),
                    1e-6);
    }
}
