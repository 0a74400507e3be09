#include "app/editor/panels/texture/adjust_page.h"

#include "app/editor/panels/texture/photo_dialog.h"
#include "app/editor/panels/texture/preparation_panel.h"
#include "core/samples/samples.h"
#include "tests/support/eventually.h"

using namespace esm;

namespace {

Project withTissuePhoto() {
    Project project = makeSample("ventricle");
    project.layers.resize(1);
    numberByPlace(project.layers);
    project.layers[0].photo = makeSamplePhoto("serosa");
    return project;
}

class AdjustPageTest : public testing::Test {
protected:
    AdjustPageTest() : document(withTissuePhoto()) {
        selection.setPhoto(document.project().layers[0].id);
        dialog = std::make_unique<PhotoDialog>(document, edits);
        dialog->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(dialog.get(), patience));
        QApplication::setActiveWindow(dialog.get());
        QTest::keyClick(dialog.get(), Qt::Key_A);
    }
    const TextureLayer& layer() const { return document.project().layers[0]; }
    const ColourAdjustment& adjustment() const { return layer().preparation.adjustment; }
    NumberField* field(const char* name) const { return dialog->findChild<NumberField*>(name); }
    ValueSlider* slider(const char* name) const { return dialog->findChild<ValueSlider*>(name); }
    void enter(const char* name, double value) const {
        emit field(name)->valueEdited(value);
        emit field(name)->gestureFinished();
    }
    void settle() const { ESM_EVENTUALLY(!edits.isWorking()); }
    /// Drags the handle to a share of the slider, by way of others.
    void drag(ValueSlider* dragged, double share) const {
        const auto at = [&](double part) {
            return QPoint(static_cast<int>(part * dragged->width()), dragged->height() / 2);
        };
        QTest::mousePress(dragged, Qt::LeftButton, {}, at(0.5));
        for (const double part : {0.5 + 0.3 * (share - 0.5), 0.5 + 0.7 * (share - 0.5), share}) {
            QMouseEvent move(QEvent::MouseMove, at(part), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(dragged, &move);
        }
        settle();
        EXPECT_NE(adjustment(), ColourAdjustment()) << "the photo follows before the handle is let go";
        QTest::mouseRelease(dragged, Qt::LeftButton, {}, at(share));
    }

    Document document;
    Selection& selection = *new Selection(document);
    PreparationEdits& edits = *new PreparationEdits(document, selection);
    std::unique_ptr<PhotoDialog> dialog;
};

} // namespace

TEST_F(AdjustPageTest, ADragOfASliderIsOneStepThatThePhotoFollows) {
    ASSERT_TRUE(slider("photoHueSlider")->isVisible());
    drag(slider("photoHueSlider"), 0.75);
    drag(slider("photoGammaSlider"), 0.9);
    settle();
    EXPECT_NEAR(adjustment().hue, 90, 25);
    EXPECT_GT(adjustment().gamma, 3);
    EXPECT_EQ(field("photoHue")->value(), adjustment().hue);
    ASSERT_TRUE(layer().prepared);
    EXPECT_EQ(layer().prepared->pixels, prepared(layer().photo->image, layer().preparation).pixels);
    EXPECT_EQ(document.undoStack()->count(), 2);
    document.undoStack()->undo();
    EXPECT_EQ(adjustment().gamma, 1);
    EXPECT_EQ(slider("photoGammaSlider")->value(), 100) << "in the middle, where nothing is bent";
    document.undoStack()->undo();
    EXPECT_TRUE(layer().preparation.isNothing());
    EXPECT_EQ(layer().prepared, nullptr);
}

TEST_F(AdjustPageTest, ComesOnTopOfAllElseThatIsDoneToThePhoto) {
    edits.edit("Balance white", [](PreparationWish& wish) {
        wish.preparation.whiteBalance = ColourGains{0.8, 1, 1.2};
        wish.preparation.highlightSensitivity = 0.5;
    });
    enter("photoSaturation", 0.5);
    enter("photoContrast", 1.2);
    settle();
    EXPECT_EQ(layer().prepared->pixels, prepared(layer().photo->image, layer().preparation).pixels);
    edits.edit("Other white", [](PreparationWish& wish) {
        wish.preparation.whiteBalance = ColourGains{1.3, 1, 0.9};
    });
    settle();
    EXPECT_EQ(adjustment().saturation, 0.5);
    EXPECT_EQ(layer().prepared->pixels, prepared(layer().photo->image, layer().preparation).pixels);
}

TEST_F(AdjustPageTest, BlackAndWhitePointGiveWayToEachOther) {
    enter("photoBlackPoint", 100);
    enter("photoWhitePoint", 60);
    settle();
    EXPECT_EQ(adjustment().whitePoint, 60);
    EXPECT_EQ(adjustment().blackPoint, 59);
    enter("photoBlackPoint", 254);
    settle();
    EXPECT_EQ(adjustment().whitePoint, 255);
    EXPECT_TRUE(edits.failure().isEmpty());
}

TEST_F(AdjustPageTest, ResetTakesThePhotoAsItWas) {
    auto* reset = dialog->findChild<QPushButton*>("resetAdjustment");
    EXPECT_FALSE(reset->isEnabled());
    enter("photoContrast", 1.5);
    enter("photoHue", -20);
    settle();
    ASSERT_TRUE(reset->isEnabled());
    reset->click();
    settle();
    EXPECT_TRUE(layer().preparation.isNothing());
    EXPECT_EQ(field("photoContrast")->value(), 1);
    EXPECT_EQ(document.undoStack()->count(), 3);
    document.undoStack()->undo();
    EXPECT_EQ(adjustment().hue, -20);
}

TEST_F(AdjustPageTest, ThePanelSaysWhatIsAdjustedAndSwitchesItOffAndOn) {
    PreparationPanel panel(edits);
    auto* box = panel.findChild<QCheckBox*>("adjustColours");
    EXPECT_FALSE(box->isEnabled());
    enter("photoHue", 12);
    enter("photoContrast", 1.2);
    settle();
    EXPECT_TRUE(box->isChecked());
    EXPECT_EQ(panel.findChild<QLabel*>("adjustColoursWords")->toolTip(), "hue 12°, contrast 120 %");
    box->click();
    settle();
    EXPECT_TRUE(layer().preparation.isNothing());
    box->click();
    settle();
    EXPECT_EQ(adjustment().hue, 12);
}
