#include "app/editor/document/change.h"

#include "core/samples/samples.h"
#include "tests/support/exchange_projects.h"

#include <gtest/gtest.h>

#include <functional>

using namespace esm;

namespace {

struct Edit {
    const char* name;
    std::function<void(Project&)> make;
    bool Change::*told; ///< what listeners hear of it
};

FuzzySystem& ownSystem(Region& region) {
    auto system = std::make_shared<FuzzySystem>(*region.system);
    region.system = std::shared_ptr<const FuzzySystem>(system);
    return *system;
}

std::vector<Edit> editsOfRegions() {
    return {
        {"name", [](Project& p) { p.regions[0].name += "!"; }, &Change::regions},
        {"colour", [](Project& p) { p.regions[0].colour[1] ^= 1; }, &Change::regions},
        {"ellipsoid", [](Project& p) { p.regions[0].ellipsoid = Ellipsoid{}; }, &Change::regions},
        {"rim", [](Project& p) { p.regions[0].rim += 0.001; }, &Change::regions},
        {"rule", [](Project& p) { ownSystem(p.regions[0]).rules[0].weight *= 0.5; }, &Change::regions},
        {"norm", [](Project& p) { ownSystem(p.regions[0]).norms.conjunction = TNorm::Product; },
         &Change::regions},
        {"unit", [](Project& p) { ownSystem(p.regions[0]).inputs[0].unit += "x"; }, &Change::regions},
        {"input", [](Project& p) { setInput(p.regions[0], "softness", 0.123); }, &Change::regions},
        {"held", [](Project& p) { p.regions[0].held.viscosity = 12.5; }, &Change::regions},
        {"order", [](Project& p) { std::swap(p.regions[0], p.regions[1]); }, &Change::regions},
    };
}

std::vector<Edit> editsOfLayers() {
    return {
        {"layer", [](Project& p) { p.layers[0].name += "!"; }, &Change::layers},
        {"pose", [](Project& p) { p.layers[0].projector.pose.translation().x() += 1; }, &Change::layers},
        {"falloff", [](Project& p) { p.layers[0].projector.falloff ^= true; }, &Change::layers},
        {"opacity", [](Project& p) { p.layers[0].opacity *= 0.5; }, &Change::layers},
        {"visible", [](Project& p) { p.layers[0].visible ^= true; }, &Change::layers},
        {"light", [](Project& p) { p.layers[0].preparation.evenLight = 0.25; }, &Change::layers},
        {"blending", [](Project& p) { p.layers[0].blending = Blending::Multiply; }, &Change::layers},
        {"stroke", [](Project& p) { p.layers[0].strokes.push_back(std::make_shared<const BrushStroke>()); },
         &Change::layers},
        {"landmark",
         [](Project& p) {
             p.layers[0].landmarks.push_back({{1, 2}, {3, 4, 5}});
         },
         &Change::landmarks},
        {"page", [](Project& p) { p.texture.atlas.size *= 2; }, &Change::texture},
        {"base colour", [](Project& p) { p.texture.baseColour[0] ^= 1; }, &Change::texture},
    };
}

std::vector<Edit> editsOfTheRest() {
    return {
        {"name", [](Project& p) { p.name += "!"; }, &Change::name},
        {"mass", [](Project& p) { p.base.mass *= 2; }, &Change::tissue},
        {"stiffening",
         [](Project& p) {
             p.base.stiffening = SpringStiffening{0.1, 3};
         },
         &Change::tissue},
        {"gravity", [](Project& p) { p.scene.gravity.y() -= 1; }, &Change::scene},
        {"force",
         [](Project& p) {
             p.scene.forces.push_back({0, {0, 0, 1}, 0, 1});
         },
         &Change::scene},
        {"path",
         [](Project& p) {
             p.scene.moves.push_back({0, {{0, {0, 0, 0}}}});
         },
         &Change::scene},
        {"rows", [](Project& p) { p.scene.record.every *= 2; }, &Change::scene},
        {"stepping",
         [](Project& p) {
             p.stepping = MeasuredStepping{{}, 0.5, 2, "digest"};
         },
         &Change::stepping},
        {"mesh", [](Project& p) { p.mesh = std::make_shared<const TriangleMesh>(*p.mesh); }, &Change::mesh},
    };
}

void expectTold(const std::vector<Edit>& edits) {
    const Project before = richProject();
    for (const Edit& edit : edits) {
        Project after = before;
        edit.make(after);
        EXPECT_TRUE(before != after) << edit.name;
        EXPECT_TRUE(difference(before, after).*edit.told) << edit.name;
        EXPECT_FALSE(difference(after, after).any()) << edit.name;
    }
}

} // namespace

TEST(Change, IsToldOfEveryEditOfARegion) {
    expectTold(editsOfRegions());
}

TEST(Change, IsToldOfEveryEditOfALayerAndTheTexture) {
    expectTold(editsOfLayers());
}

TEST(Change, IsToldOfEveryOtherEdit) {
    expectTold(editsOfTheRest());
}

TEST(Change, IsNoneWhereAnEqualSystemTakesTheOldOnesPlace) {
    const Project before = richProject();
    Project after = before;
    ownSystem(after.regions[0]);
    EXPECT_TRUE(before == after);
    EXPECT_FALSE(difference(before, after).any());
}

TEST(Change, OfLandmarksLeavesThePictureAsItIs) {
    const Project before = richProject();
    Project after = before;
    after.layers[0].landmarks.push_back({{1, 2}, {3, 4, 5}});
    EXPECT_FALSE(difference(before, after).picture());
}
