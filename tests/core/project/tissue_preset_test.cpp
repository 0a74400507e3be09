#include "core/project/tissue_preset.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(TissuePreset, GivesARegionItsWords) {
    TissuePreset preset;
    Region region;
    region.held = {1, 2, 3};
    layPreset(region, preset);
    EXPECT_EQ(region.held.springConstant, 1) << "it says nothing of tissue";
    preset.system = std::make_shared<const FuzzySystem>();
    preset.inputs = {{"consistency", 5.5}};
    layPreset(region, preset);
    EXPECT_EQ(region.system, preset.system);
    EXPECT_EQ(region.inputs, preset.inputs);
    EXPECT_FALSE(region.held.springConstant || region.held.viscosity);
    EXPECT_EQ(region.held.mass, 3);
}

TEST(TissuePreset, TiesTheOrganWhereItSaysHow) {
    TissuePreset preset;
    Scene scene;
    scene.tethers = {{1, 2, 3}};
    tiePreset(scene, preset);
    EXPECT_EQ(scene.tethers.size(), 1U);
    preset.tethers = {{3, 4, 5}, {4, 5, 6}};
    tiePreset(scene, preset);
    EXPECT_EQ(scene.tethers.size(), 2U);
}
