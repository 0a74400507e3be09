#include "core/authoring/layers.h"

#include "core/authoring/packing.h"
#include "core/samples/samples.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;

namespace {

/// Two photos and a painted layer over them.
Project withThreeLayers() {
    Project project = makeSample("tube");
    project.layers.clear();
    packIfNeeded(project);
    for (int i = 0; i < 2; ++i)
        addPhoto(project, nextId(project.layers), makeSamplePhoto("serosa"), Projector{}, project.atlas);
    addPaintLayer(project, nextId(project.layers), project.atlas);
    return project;
}

std::vector<std::uint32_t> numbersOf(const Project& project) {
    std::vector<std::uint32_t> numbers;
    for (const TextureLayer& layer : project.layers)
        numbers.push_back(layer.id.number);
    return numbers;
}

TEST(Layers, LieInTheOrderInWhichTheyAreAdded) {
    const Project project = withThreeLayers();
    EXPECT_THAT(numbersOf(project), ElementsAre(1, 2, 3));
    EXPECT_TRUE(project.layers[1].photo);
    EXPECT_TRUE(project.layers[1].projector.falloff);
    EXPECT_FALSE(project.layers[2].photo);
}

TEST(Layers, PaintedOnesAreNamedApart) {
    Project project = withThreeLayers();
    addPaintLayer(project, nextId(project.layers), project.atlas);
    EXPECT_EQ(project.layers[2].name, "Paint 1");
    EXPECT_EQ(project.layers[3].name, "Paint 2");
}

TEST(Layers, MoveAsFarAsThereAreOthers) {
    Project project = withThreeLayers();
    moveLayer(project, {1}, 2);
    EXPECT_THAT(numbersOf(project), ElementsAre(2, 3, 1));
    EXPECT_FALSE(canMoveLayer(project, {1}, 1));
    EXPECT_FALSE(canMoveLayer(project, {7}, 1)) << "not there";
    moveLayer(project, {1}, 1);
    removeLayer(project, {3});
    removeLayer(project, {3});
    EXPECT_THAT(numbersOf(project), ElementsAre(2, 1));
}

TEST(Layers, AreCopiedWithAllThatBelongsToThem) {
    Project project = withThreeLayers();
    TextureLayer& original = project.layers[0];
    original.opacity = 0.4;
    original.projector.width = 0.07;
    original.preparation.crop = PhotoCrop{1, 2, 3, 4};
    original.landmarks.emplace_back();
    original.strokes.push_back(std::make_shared<const BrushStroke>());
    duplicateLayer(project, {1}, {9});
    EXPECT_THAT(numbersOf(project), ElementsAre(1, 9, 2, 3));
    TextureLayer copy = project.layers[1];
    EXPECT_EQ(copy.name, project.layers[0].name + " copy");
    copy.name = project.layers[0].name;
    EXPECT_EQ(copy, project.layers[0]);
    duplicateLayer(project, {1}, {10});
    EXPECT_EQ(project.layers[1].name, project.layers[0].name + " copy 2");
}

} // namespace
