#include "core/model/scene_events.h"

#include <gmock/gmock.h>

#include <functional>

using namespace esm;
using namespace testing;

namespace {

/// What holds an organ, or acts on it all the time.
Scene lasting() {
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.fixed.push_back({{1, 2}, {}});
    scene.tethers.push_back({});
    scene.fillings = {{0, 1000}};
    scene.pressures = {{0, {{0, 1000}}}};
    return scene;
}

} // namespace

TEST(SceneEvents, OfThemNothingStaysAndOfTheRestAll) {
    EXPECT_FALSE(hasEvents(Scene{}));
    EXPECT_FALSE(hasEvents(lasting()));
    Scene longer = lasting();
    longer.duration = 3;
    EXPECT_EQ(withoutEvents(longer), longer);
    for (const std::function<void(Scene&)>& add : std::initializer_list<std::function<void(Scene&)>>{
             [](Scene& scene) { scene.forces.push_back({}); },
             [](Scene& scene) {
                 scene.moves.push_back({3, {{0, {0, 0, 0}}}});
             },
             [](Scene& scene) { scene.instruments.push_back({}); },
             [](Scene& scene) { scene.splits.push_back({}); },
             [](Scene& scene) {
                 scene.pressures.push_back({1, {{0, 0}, {1, 1000}}});
             }}) {
        Scene scene = lasting();
        add(scene);
        scene.duration = 3;
        scene.record = {0.5, {{1}}};
        EXPECT_TRUE(hasEvents(scene));
        EXPECT_EQ(withoutEvents(scene), lasting());
    }
}
