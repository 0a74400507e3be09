#include "app/editor/panels/texture/wet_look_panel.h"

#include "core/authoring/packing.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "widgets/inputs/item_list.h"

using namespace esm;

namespace {

class WetLookPanelTest : public EditorTest {
protected:
    void SetUp() override {
        Project organ = makeSample("tube");
        organ.layers.clear();
        TextureLayer photo;
        photo.name = "photo";
        photo.photo = makeSamplePhoto("serosa");
        organ.layers.push_back(photo);
        packIfNeeded(organ);
        open(std::move(organ));
        press(Qt::Key_2, Qt::ControlModifier);
        child<ItemList>("photoList")->setCurrentRow(0);
    }
    void choose(const char* name, const QString& entry) const {
        auto* box = child<QComboBox>(name);
        ASSERT_GE(box->findText(entry), 0) << entry.toStdString();
        box->setCurrentText(entry);
        emit box->activated(box->currentIndex());
    }
    void chooseTissue(const QString& tissue) const { choose("wetLookTissue", tissue); }
    void type(const char* field, const QString& text) {
        auto* number = child<NumberField>(field);
        typeInto(number, text);
        QTest::keyClick(number, Qt::Key_Return);
    }
    const std::optional<LayerFinish>& finish() const { return project().layers.front().finish; }
};

} // namespace

TEST_F(WetLookPanelTest, SaysHowTheLayerShinesAndTakesItBack) {
    EXPECT_FALSE(child<NumberField>("wetLookWetness")->isEnabled());
    chooseTissue("mucosa");
    ASSERT_TRUE(finish());
    EXPECT_EQ(finish()->surface, (SurfaceFinish{0.45, 1}));
    type("wetLookWetness", "40");
    type("wetLookAtHighlights", "80");
    type("wetLookRelief", "0.3");
    EXPECT_EQ(*finish(), (LayerFinish{{0.45, 0.4}, 0.8, 0.0003, false}));
    EXPECT_EQ(child<QComboBox>("wetLookTissue")->currentText(), "own numbers");
    EXPECT_EQ(child<ValueSlider>("wetLookWetnessSlider")->value(), 40);
    for (int step = 0; step < 3; ++step)
        window->document().undoStack()->undo();
    EXPECT_EQ(*finish(), (LayerFinish{{0.45, 1}, 0, 0, false}));
    window->document().undoStack()->undo();
    EXPECT_FALSE(finish());
    EXPECT_EQ(child<QComboBox>("wetLookTissue")->currentIndex(), 0);
}

TEST_F(WetLookPanelTest, AMoveOfASliderIsOneStep) {
    chooseTissue("fat");
    const int steps = window->document().undoStack()->index();
    auto* slider = child<ValueSlider>("wetLookRoughnessSlider");
    for (const int place : {60, 70, 80})
        slider->setValue(place);
    emit slider->gestureFinished();
    EXPECT_EQ(finish()->surface.roughness, 0.8);
    EXPECT_EQ(window->document().undoStack()->index(), steps + 1);
}

TEST_F(WetLookPanelTest, SpeaksOfTheOrganWhereItIsAskedTo) {
    choose("wetLookSubject", "whole organ");
    chooseTissue("serosa");
    EXPECT_FALSE(finish());
    EXPECT_EQ(project().texture.finish, (SurfaceFinish{0.35, 0.8}));
    EXPECT_FALSE(child<NumberField>("wetLookRelief")->isEnabled());
    chooseTissue("none");
    EXPECT_FALSE(project().texture.finish);
}

TEST_F(WetLookPanelTest, AsksForOcclusionOfTheOrgan) {
    EXPECT_FALSE(child<NumberField>("wetLookOcclusion")->isEnabled()) << "of a layer";
    choose("wetLookSubject", "whole organ");
    type("wetLookOcclusion", "12");
    EXPECT_EQ(project().texture.occlusionReach, 0.012);
    EXPECT_FALSE(project().texture.finish) << "nothing else was asked for";
    window->document().undoStack()->undo();
    EXPECT_EQ(project().texture.occlusionReach, 0);
}

TEST_F(WetLookPanelTest, SaysThatAPhotoOfOneColourGivesNoRelief) {
    chooseTissue("mucosa");
    type("wetLookRelief", "0.3");
    auto* warnings = child<QLabel>("wetLookWarnings");
    EXPECT_FALSE(warnings->text().contains("one colour")) << warnings->text().toStdString();
    window->document().edit("one colour", [](Project& project) {
        auto plain = std::make_shared<Photo>(*project.layers[0].photo);
        for (std::size_t i = 0; i < plain->image.pixels.size(); ++i)
            plain->image.pixels[i] = i % 4 == 3 ? 255 : 90;
        project.layers[0].photo = plain;
        project.layers[0].prepared = nullptr;
    });
    EXPECT_FALSE(warnings->isHidden());
    EXPECT_TRUE(warnings->text().contains("one colour")) << warnings->text().toStdString();
}

TEST_F(WetLookPanelTest, SaysThatTheRestOfTheOrganHasNoWetLook) {
    auto* warnings = child<QLabel>("wetLookWarnings");
    EXPECT_TRUE(warnings->isHidden());
    chooseTissue("mucosa");
    EXPECT_TRUE(warnings->text().contains("whole organ")) << warnings->text().toStdString();
    choose("wetLookSubject", "whole organ");
    chooseTissue("serosa");
    choose("wetLookSubject", "selected layer");
    EXPECT_TRUE(warnings->isHidden()) << warnings->text().toStdString();
}

TEST_F(WetLookPanelTest, IsSeenInTheView) {
    chooseTissue("mucosa");
    const auto scene = [this]() -> const RenderScene& { return window->view().scene(); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return scene().finishPages != nullptr; }, patience));
    EXPECT_TRUE(scene().finish);
    press(Qt::Key_E, Qt::ShiftModifier);
    EXPECT_EQ(scene().light, SceneLight::Endoscope);
    press(Qt::Key_B);
    EXPECT_FALSE(scene().finish) << "bare, without photos and their shine";
    press(Qt::Key_B);
    window->document().undoStack()->undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return scene().finishPages == nullptr; }, patience));
    EXPECT_FALSE(scene().finish);
}
