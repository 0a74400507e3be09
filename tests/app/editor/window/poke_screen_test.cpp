#include "app/editor/panels/measure/measure_column.h"
#include "core/model/scene_events.h"
#include "core/project/detail_change.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <fstream>

using namespace esm;

namespace {

class PokeScreenTest : public EditorTest {
protected:
    void SetUp() override {
        open(withDetail(makeSample("liver"), {Detail::Kind::Nodes, 500}));
        window->windowActions().measure->trigger();
        child<QTabBar>("measurePages")->setCurrentIndex(2);
    }
    bool isSaid(const char* label, const QString& text) { return child<QLabel>(label)->text() == text; }
    QPushButton& button(const char* name) { return *child<QPushButton>(name); }

    /// As the panel says, s.
    double recordedTime() { return child<QLabel>("pokeLength")->text().section(' ', 0, 0).toDouble(); }

    /// Presses Record, pulls at the middle of the organ for some time, and presses Stop.
    void poke() {
        button("recordPoke").click();
        ESM_EVENTUALLY(recordedTime() > 0);
        QWidget& view = window->view();
        const QPoint middle = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, {}, middle);
        moveMouse(middle + QPoint(40, 20));
        ESM_EVENTUALLY(window->preview().status().pull.has_value());
        const double pulledFrom = recordedTime();
        ESM_EVENTUALLY(recordedTime() > pulledFrom + 0.4);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(40, 20));
        button("recordPoke").click();
        ESM_EVENTUALLY(!isSaid("pokeForce", QChar(0x2013)));
    }
    void stiffen() {
        window->document().edit("stiffen", [](Project& project) {
            for (Region& region : project.regions)
                region.held.springConstant = 3 * region.held.springConstant.value_or(100);
        });
    }
};

TEST_F(PokeScreenTest, APokeIsRecordedRepeatedAndWatchedBesideTheOneBefore) {
    EXPECT_EQ(toolInHand(), "pull");
    EXPECT_FALSE(button("repeatPoke").isEnabled());
    EXPECT_FALSE(button("watchPoke").isEnabled());
    poke();
    EXPECT_EQ(button("recordPoke").text(), "Record");
    const double soft = child<QLabel>("pokeForce")->text().toDouble();
    EXPECT_GT(soft, 0);
    stiffen();
    EXPECT_TRUE(child<QLabel>("pokeMessage")->text().contains("repeat"));
    button("repeatPoke").click();
    ESM_EVENTUALLY(!isSaid("pokeForceBefore", QChar(0x2013)));
    EXPECT_GT(child<QLabel>("pokeForce")->text().toDouble(), 1.2 * soft);

    window->preview().setPlaying(true);
    ESM_EVENTUALLY(window->preview().status().playing);
    EXPECT_FALSE(child<QWidget>("formerView")->isVisible());
    button("watchPoke").click();
    EXPECT_TRUE(child<QWidget>("formerView")->isVisible());
    EXPECT_EQ(toolInHand(), "look");
    ESM_EVENTUALLY(!window->preview().status().playing);
    button("leavePoke").click();
    EXPECT_FALSE(child<QWidget>("formerView")->isVisible());
    ESM_EVENTUALLY(window->preview().status().playing);
}

TEST_F(PokeScreenTest, AMomentShowsTheOrganAsItWasPulledAndTheOtherTurnsAlong) {
    poke();
    child<QPushButton>("keepPoke")->click();
    button("repeatPoke").click();
    ESM_EVENTUALLY(button("repeatPoke").isEnabled() && !button("cancelPoke").isEnabled());
    auto* slider = child<QSlider>("pokeMoment");
    slider->setValue(slider->maximum() / 2);
    auto* former = child<OrganView>("formerView");
    ASSERT_TRUE(former->isVisible());
    const auto& rest = window->document().project().network->restPositions;
    EXPECT_NE(window->view().scene().nodePositions, rest);
    EXPECT_EQ(former->scene().nodePositions, window->view().scene().nodePositions) << "the same tissue";
    window->view().showView(StandardView::Top);
    EXPECT_TRUE(former->camera() == window->view().camera());
    former->showView(StandardView::Left);
    EXPECT_TRUE(former->camera() == window->view().camera());
    EXPECT_EQ(child<QLabel>("pokeForceShown")->text(), child<QLabel>("pokeForceShownBefore")->text());
    slider->setValue(0);
    const double apart = (window->view().scene().nodePositions[40] - rest[40]).norm();
    EXPECT_LT(apart, 1e-6) << "it began at rest";
}

TEST_F(PokeScreenTest, WhoTakesAToolWantsTheLivingOrgan) {
    poke();
    button("watchPoke").click();
    EXPECT_TRUE(button("leavePoke").isEnabled());
    window->windowActions().tool("pull")->trigger();
    EXPECT_FALSE(button("leavePoke").isEnabled());
    button("watchPoke").click();
    child<QTabBar>("measurePages")->setCurrentIndex(0);
    EXPECT_FALSE(button("leavePoke").isEnabled());
    child<QTabBar>("measurePages")->setCurrentIndex(2);
    button("watchPoke").click();
    window->windowActions().tissue->trigger();
    EXPECT_FALSE(button("leavePoke").isEnabled());
}

TEST_F(PokeScreenTest, PlayGoesOnWithTheLivingOrgan) {
    poke();
    window->preview().setPlaying(true);
    ESM_EVENTUALLY(window->preview().status().playing);
    button("watchPoke").click();
    ESM_EVENTUALLY(!window->preview().status().playing);
    window->windowActions().play->trigger();
    EXPECT_FALSE(button("leavePoke").isEnabled());
    ESM_EVENTUALLY(window->preview().status().playing);
}

TEST_F(PokeScreenTest, RecordingNeedsAToolThatTouches) {
    window->windowActions().tool("look")->trigger();
    button("recordPoke").click();
    EXPECT_EQ(toolInHand(), "pull");
    button("recordPoke").click();
    EXPECT_TRUE(child<QLabel>("pokeMessage")->text().contains("touched nothing"));
    window->windowActions().tool("instrument")->trigger();
    button("recordPoke").click();
    EXPECT_EQ(toolInHand(), "instrument");
    button("recordPoke").click();
}

TEST_F(PokeScreenTest, APullIsMadeTheSceneAndTheSceneTakenAway) {
    const Scene& scene = window->document().project().scene;
    window->document().edit("force", [](Project& project) {
        project.scene = withoutEvents(project.scene);
        project.scene.forces.push_back({3, {0, 0, 1}, 0, 1});
    });
    const Scene before = scene;
    QAction& removing = *window->windowActions().removeScene;
    EXPECT_FALSE(button("makePokeScene").isEnabled());
    EXPECT_TRUE(removing.isEnabled());
    poke();
    button("makePokeScene").click();
    EXPECT_TRUE(scene.forces.empty());
    EXPECT_FALSE(scene.moves.empty());
    EXPECT_EQ(scene.fixed, before.fixed);
    EXPECT_TRUE(window->windowActions().playScene->isEnabled());
    removing.trigger();
    EXPECT_TRUE(scene.moves.empty());
    EXPECT_FALSE(removing.isEnabled());
    window->document().undoStack()->undo();
    EXPECT_FALSE(scene.moves.empty());
    window->document().undoStack()->undo();
    EXPECT_EQ(scene, before);
}

TEST_F(PokeScreenTest, OnOtherNodesNoFilmIsOffered) {
    poke();
    EXPECT_TRUE(button("saveFilm").isEnabled());
    window->document().edit("nodes", [](Project& project) {
        project = withDetail(project, {Detail::Kind::Nodes, 300});
    });
    EXPECT_FALSE(button("saveFilm").isEnabled());
}

TEST_F(PokeScreenTest, FilmTableAndChartAreWrittenWhereTheUserSays) {
    const TemporaryFolder folder;
    poke();
    dialogs.expectFile(folder / "poke.avi");
    button("saveFilm").click();
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_GT(std::filesystem::file_size(folder / "poke.avi"), 10000U);
    dialogs.expectFile(folder / "POKE.AVI");
    button("saveFilm").click();
    EXPECT_EQ(std::filesystem::file_size(folder / "POKE.AVI"),
              std::filesystem::file_size(folder / "poke.avi"));
    dialogs.expectFile(folder / "poke.csv");
    button("savePokeTable").click();
    dialogs.expectFile(folder / "poke.png");
    button("savePokeChart").click();
    EXPECT_TRUE(dialogs.isDone());
    std::ifstream table(folder / "poke.csv");
    std::string names, first;
    std::getline(table, names);
    std::getline(table, first);
    EXPECT_EQ(names, "name,time_s,force_n,displacement_m");
    EXPECT_EQ(first, "now,0,0,0");
    EXPECT_TRUE(std::filesystem::exists(folder / "poke.png"));
}

} // namespace
