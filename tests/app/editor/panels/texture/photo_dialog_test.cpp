#include "app/editor/panels/texture/photo_dialog.h"

#include "core/exchange/project/preparation_json.h"
#include "core/samples/samples.h"
#include "core/texture/photo/highlights.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

using namespace esm;

namespace {

constexpr int photoWidth = 400, photoHeight = 320;

Project withPhoto() {
    Project project = makeSample("ventricle");
    auto photo = std::make_shared<Photo>();
    photo->fileName = "grey.png";
    photo->image.width = photoWidth;
    photo->image.height = photoHeight;
    photo->image.pixels.assign(4 * photoWidth * photoHeight, 255);
    TextureLayer layer;
    layer.name = "grey";
    layer.photo = photo;
    project.layers = {layer};
    return project;
}

class PhotoDialogTest : public testing::Test {
protected:
    PhotoDialogTest() : document(withPhoto()) {
        selection.setPhoto(document.project().layers[0].id);
        dialog = std::make_unique<PhotoDialog>(document, edits);
        dialog->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(dialog.get(), patience));
        QApplication::setActiveWindow(dialog.get());
        canvas = dialog->findChild<PhotoCanvas*>();
    }
    const TextureLayer& layer() const { return document.project().layers[0]; }
    QPoint placeOf(double x, double y) const { return canvas->toWidget({x, y}).toPoint(); }
    void drag(double fromX, double fromY, double toX, double toY) const {
        QTest::mousePress(canvas, Qt::LeftButton, {}, placeOf(fromX, fromY));
        for (const double share : {0.3, 0.7, 1.0}) {
            const QPoint at = placeOf(fromX + share * (toX - fromX), fromY + share * (toY - fromY));
            QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(canvas, &move);
        }
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, placeOf(toX, toY));
    }
    void draw(const Lens& lens, const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
        for (int i = 0; i <= 6; ++i) {
            const Eigen::Vector2d place = distorted(lens, from + i / 6.0 * (to - from));
            QTest::mouseClick(canvas, Qt::LeftButton, {}, placeOf(place.x(), place.y()));
        }
        QTest::keyClick(canvas, Qt::Key_Return);
    }
    void choose(Qt::Key tool) const { QTest::keyClick(dialog.get(), tool); }

    Document document;
    Selection& selection = *new Selection(document);
    PreparationEdits& edits = *new PreparationEdits(document, selection);
    std::unique_ptr<PhotoDialog> dialog;
    PhotoCanvas* canvas = nullptr;
};

} // namespace

TEST_F(PhotoDialogTest, LeavesOutWhatIsBrushedOverAndTakesItBack) {
    auto* radius = dialog->findChild<NumberField*>("photoBrushRadius");
    radius->setValue(15);
    emit radius->valueEdited(15);
    choose(Qt::Key_E);
    drag(100, 100, 300, 100);
    ESM_EVENTUALLY(!edits.isWorking());
    ASSERT_EQ(layer().preparation.strokes.size(), 1U);
    EXPECT_EQ(layer().preparation.strokes[0].radius, 15);
    ASSERT_TRUE(layer().prepared);
    EXPECT_EQ(layer().prepared->at(200, 100)[3], 0);
    EXPECT_EQ(layer().prepared->at(200, 130)[3], 255);
    choose(Qt::Key_R);
    drag(200, 100, 201, 100);
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(layer().prepared->at(200, 100)[3], 255);
    EXPECT_EQ(layer().prepared->at(120, 100)[3], 0);
    EXPECT_EQ(document.undoStack()->count(), 2);
    QTest::keyClick(dialog.get(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(layer().prepared->at(200, 100)[3], 0);
}

TEST_F(PhotoDialogTest, StraightensByDrawnLines) {
    const double half = 0.5 * std::hypot(photoWidth, photoHeight);
    const Lens known{LensKind::Pinhole, {half, half, 200, 160}, {-0.2, 0, 0, 0, 0}};
    auto* straighten = dialog->findChild<QPushButton*>("straightenPhoto");
    choose(Qt::Key_L);
    draw(known, {30, 30}, {370, 20});
    EXPECT_FALSE(straighten->isEnabled());
    draw(known, {20, 300}, {380, 290});
    ASSERT_TRUE(straighten->isEnabled());
    straighten->click();
    ESM_EVENTUALLY(!edits.isWorking());
    ASSERT_TRUE(layer().preparation.lens);
    EXPECT_NEAR(layer().preparation.lens->coefficients[0], -0.2, 0.02);
}

TEST_F(PhotoDialogTest, ALineThatWasNotEndedGoesWithItsTool) {
    choose(Qt::Key_L);
    QTest::mouseClick(canvas, Qt::LeftButton, {}, placeOf(50, 50));
    choose(Qt::Key_C);
    choose(Qt::Key_L);
    draw({LensKind::Pinhole, {100, 100, 200, 160}, {}}, {30, 200}, {370, 200});
    ASSERT_EQ(canvas->lines().size(), 1U);
    EXPECT_EQ(canvas->lines()[0].size(), 7U);
}

TEST_F(PhotoDialogTest, SaysWhyLinesDoNotDo) {
    choose(Qt::Key_L);
    const Lens none{LensKind::Pinhole, {100, 100, 200, 160}, {}};
    draw(none, {0, 160}, {400, 160});
    draw(none, {200, 0}, {200, 320});
    dialog->findChild<QPushButton*>("straightenPhoto")->click();
    EXPECT_TRUE(dialog->findChild<QLabel*>("photoHint")->text().contains("do not tell"));
    EXPECT_EQ(document.undoStack()->count(), 0);
}

TEST_F(PhotoDialogTest, ALensServesOtherPhotosByItsFile) {
    const TemporaryFolder folder;
    const Lens known{LensKind::Fisheye, {150, 151, 200, 160}, {0.1, 0.01, 0, 0, 0}};
    writeLensFile(known, folder / "scope.json");
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    DialogScript dialogs;
    choose(Qt::Key_L);
    EXPECT_FALSE(dialog->findChild<QPushButton*>("saveLens")->isEnabled());
    dialogs.expectFile(folder / "scope.json");
    dialog->findChild<QPushButton*>("loadLens")->click();
    ESM_EVENTUALLY(layer().preparation.lens);
    EXPECT_EQ(*layer().preparation.lens, known);
    EXPECT_EQ(document.undoStack()->count(), 1);
    dialogs.expectFile(folder / "copy.json");
    dialog->findChild<QPushButton*>("saveLens")->click();
    EXPECT_EQ(readLensFile(folder / "copy.json"), known);
    EXPECT_TRUE(dialogs.isDone());
}

TEST_F(PhotoDialogTest, CropsByAFrameAndByNumbers) {
    choose(Qt::Key_C);
    drag(50, 40, 250, 240);
    ESM_EVENTUALLY(!edits.isWorking());
    ASSERT_TRUE(layer().preparation.crop);
    EXPECT_NEAR(layer().preparation.crop->x, 50, 1);
    EXPECT_NEAR(layer().preparation.crop->height, 200, 2);
    EXPECT_EQ(document.undoStack()->count(), 1);
    auto* width = dialog->findChild<NumberField*>("cropWidth");
    emit width->valueEdited(9000);
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(layer().preparation.crop->x + layer().preparation.crop->width, photoWidth);
    EXPECT_EQ(layer().prepared->at(10, 100)[3], 0);
}

TEST_F(PhotoDialogTest, EscapeDropsWhatIsDrawnAndThenClosesTheDialog) {
    const auto begin = [&] {
        QTest::mousePress(canvas, Qt::LeftButton, {}, placeOf(100, 100));
        QMouseEvent move(QEvent::MouseMove, placeOf(200, 160), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(canvas, &move);
    };
    const auto drop = [&] {
        QTest::keyClick(canvas, Qt::Key_Escape);
        EXPECT_TRUE(dialog->isVisible());
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, placeOf(200, 160));
    };
    begin();
    drop();
    EXPECT_TRUE(layer().preparation.strokes.empty());
    choose(Qt::Key_C);
    begin();
    ESM_EVENTUALLY(layer().preparation.crop.has_value());
    drop();
    ESM_EVENTUALLY(!layer().preparation.crop);
    QTest::keyClick(canvas, Qt::Key_Escape);
    EXPECT_FALSE(dialog->isVisible());
}

TEST_F(PhotoDialogTest, CancelPutsBackWhatWasDone) {
    drag(100, 100, 300, 100);
    drag(100, 200, 300, 200); // waits for its picture
    dialog->findChild<QPushButton*>("cancelPhoto")->click();
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_TRUE(layer().preparation.isNothing());
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_TRUE(layer().preparation.isNothing());
    EXPECT_EQ(document.undoStack()->index(), 0);
}

TEST_F(PhotoDialogTest, AsksBeforeWhatWasDoneIsPutBack) {
    DialogScript dialogs;
    drag(100, 100, 300, 100);
    ESM_EVENTUALLY(!edits.isWorking());
    dialogs.expectButton("keepPhotoBox", QMessageBox::Cancel);
    QTest::keyClick(canvas, Qt::Key_Escape);
    EXPECT_TRUE(dialog->isVisible());
    dialogs.expectNamed("keepPhotoBox", [](QDialog* box) { QTest::keyClick(box, Qt::Key_K); });
    QTest::keyClick(canvas, Qt::Key_Escape);
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_EQ(layer().preparation.strokes.size(), 1U);
}

TEST_F(PhotoDialogTest, UndoesOnlyWhatWasDoneInIt) {
    dialog->findChild<QPushButton*>("keepPhoto")->click();
    document.edit("Hide", [](Project& project) { project.layers[0].visible = false; });
    dialog = std::make_unique<PhotoDialog>(document, edits);
    dialog->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog.get(), patience));
    QApplication::setActiveWindow(dialog.get());
    canvas = dialog->findChild<PhotoCanvas*>();
    drag(100, 100, 300, 100);
    ESM_EVENTUALLY(!edits.isWorking());
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(dialog.get(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(layer().preparation.isNothing());
    EXPECT_FALSE(layer().visible);
    EXPECT_EQ(document.undoStack()->index(), 1);
}

TEST_F(PhotoDialogTest, SaysWhyAPhotoIsNotPrepared) {
    const auto hint = [this] { return dialog->findChild<QLabel*>("photoHint")->text(); };
    edits.edit("Crop", [](PreparationWish& wish) {
        wish.preparation.crop = PhotoCrop{0, 0, photoWidth + 1, 9};
    });
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_TRUE(hint().startsWith("Not prepared: ")) << hint().toStdString();
    choose(Qt::Key_R);
    EXPECT_FALSE(hint().startsWith("Not prepared: ")) << "what the tool does is to be read too";
}

TEST_F(PhotoDialogTest, ClosesWithItsPhoto) {
    document.edit("Remove", [](Project& project) { project.layers.clear(); });
    EXPECT_FALSE(dialog->isVisible());
}

TEST_F(PhotoDialogTest, LeavesOutWhatIsOutlinedAndTakesItBackWithCtrl) {
    choose(Qt::Key_X);
    drag(50, 50, 150, 120);
    ESM_EVENTUALLY(!edits.isWorking());
    ASSERT_EQ(layer().preparation.strokes.size(), 1U);
    EXPECT_TRUE(layer().preparation.strokes[0].isFilled);
    EXPECT_EQ(layer().prepared->at(100, 85)[3], 0);
    EXPECT_EQ(layer().prepared->at(160, 85)[3], 255);
    choose(Qt::Key_O);
    QTest::mousePress(canvas, Qt::LeftButton, Qt::ControlModifier, placeOf(80, 70));
    for (const auto& [x, y] : {std::pair{120, 70}, std::pair{120, 100}, std::pair{80, 100}}) {
        QMouseEvent move(QEvent::MouseMove, placeOf(x, y), Qt::NoButton, Qt::LeftButton, Qt::ControlModifier);
        QApplication::sendEvent(canvas, &move);
    }
    QTest::mouseRelease(canvas, Qt::LeftButton, Qt::ControlModifier, placeOf(80, 100));
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(layer().prepared->at(100, 85)[3], 255);
    EXPECT_EQ(layer().prepared->at(60, 60)[3], 0);
}

TEST_F(PhotoDialogTest, AClickOrALineOutlinesNothing) {
    for (const Qt::Key key : {Qt::Key_X, Qt::Key_O}) {
        choose(key);
        QTest::mouseClick(canvas, Qt::LeftButton, {}, placeOf(50, 50));
        drag(50, 50, 150, 50);
    }
    EXPECT_FALSE(edits.isWorking());
    EXPECT_EQ(document.undoStack()->count(), 0);
}

TEST_F(PhotoDialogTest, DrawsAFieldAndMendsItByItsHandles) {
    choose(Qt::Key_F);
    drag(200, 160, 300, 160);
    ESM_EVENTUALLY(!edits.isWorking());
    ASSERT_TRUE(layer().preparation.field);
    EXPECT_TRUE(layer().preparation.field->isCircle());
    EXPECT_NEAR(layer().preparation.field->radii.x(), 100, 2);
    EXPECT_EQ(document.undoStack()->count(), 1) << "one drag, one step";
    drag(300, 160, 320, 160); // the radius
    drag(200, 160, 190, 150); // the middle
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_NEAR(layer().preparation.field->radii.x(), 120, 2);
    EXPECT_NEAR(layer().preparation.field->centre.y(), 150, 2);
    EXPECT_EQ(layer().prepared->at(190, 150)[3], 255);
    EXPECT_EQ(layer().prepared->at(5, 5)[3], 0);
    QTest::keyClick(dialog.get(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NEAR(layer().preparation.field->centre.y(), 160, 2);
}

TEST_F(PhotoDialogTest, AFieldHasTheShapeThatIsChosen) {
    const auto shape = [this](const char* name) {
        for (auto* button : dialog->findChildren<QPushButton*>())
            if (button->text().remove('&') == name) button->click();
        ESM_EVENTUALLY(!edits.isWorking());
    };
    choose(Qt::Key_F);
    drag(200, 160, 260, 160);
    shape("Ellipse");
    drag(200, 220, 200, 190); // the second radius alone
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_NEAR(layer().preparation.field->radii.x(), 60, 2);
    EXPECT_NEAR(layer().preparation.field->radii.y(), 30, 2);
    shape("Polygon");
    ASSERT_EQ(layer().preparation.field->shape, FieldShape::Polygon);
    EXPECT_EQ(layer().preparation.field->corners.size(), 12U);
    drag(260, 160, 300, 160); // its first corner
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_NEAR(layer().preparation.field->corners[0].x(), 300, 2);
    QTest::keyClick(canvas, Qt::Key_Backspace);
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(layer().preparation.field->corners.size(), 11U);
    shape("No field");
    EXPECT_FALSE(layer().preparation.field);
}

TEST_F(PhotoDialogTest, EscapePutsTheFieldBackThatWasDragged) {
    choose(Qt::Key_F);
    drag(200, 160, 300, 160);
    ESM_EVENTUALLY(!edits.isWorking());
    const PhotoField before = *layer().preparation.field;
    QTest::mousePress(canvas, Qt::LeftButton, {}, placeOf(200, 160));
    QMouseEvent move(QEvent::MouseMove, placeOf(240, 160), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_NE(*layer().preparation.field, before);
    QTest::keyClick(canvas, Qt::Key_Escape);
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(*layer().preparation.field, before);
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, placeOf(240, 160));
}

TEST_F(PhotoDialogTest, LeavesOutTheRegionThatIsClicked) {
    document.edit("Paint", [](Project& project) {
        auto photo = std::make_shared<Photo>(*project.layers[0].photo);
        for (int y = 100; y < 200; ++y)
            for (int x = 100; x < 200; ++x)
                photo->image.at(x, y)[0] = 90;
        project.layers[0].photo = photo;
    });
    choose(Qt::Key_G);
    QTest::mouseClick(canvas, Qt::LeftButton, {}, placeOf(150, 150));
    ESM_EVENTUALLY(!edits.isWorking() && layer().prepared);
    EXPECT_EQ(layer().prepared->at(150, 150)[3], 0);
    EXPECT_EQ(layer().prepared->at(50, 50)[3], 255);
}

TEST_F(PhotoDialogTest, FillsHighlightsAsTheSliderSaysOnceItIsLetGo) {
    choose(Qt::Key_H);
    auto* slider = dialog->findChild<ValueSlider*>("highlightSensitivity");
    ASSERT_TRUE(slider->isVisible());
    dialog->findChild<QCheckBox*>("fillHighlights")->click();
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(layer().preparation.highlightSensitivity, usualSensitivity);
    slider->setValue(80);
    EXPECT_EQ(layer().preparation.highlightSensitivity, usualSensitivity) << "only marked so far";
    emit slider->gestureFinished();
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(layer().preparation.highlightSensitivity, 0.8);
    EXPECT_EQ(document.undoStack()->count(), 2);
}

TEST_F(PhotoDialogTest, BalancesWhiteByASpotAndByAnotherPhoto) {
    document.edit("Warm", [](Project& project) {
        auto photo = std::make_shared<Photo>(*project.layers[0].photo);
        for (std::size_t i = 0; i < photo->image.pixels.size(); i += 4) {
            photo->image.pixels[i] = 180;
            photo->image.pixels[i + 1] = 120;
            photo->image.pixels[i + 2] = 100;
        }
        TextureLayer other = project.layers[0];
        project.layers[0].photo = photo;
        auto redder = std::make_shared<Photo>(*photo);
        for (std::size_t i = 0; i < redder->image.pixels.size(); i += 4)
            redder->image.pixels[i] = 200;
        other.photo = redder;
        other.name = "other";
        other.id = {};
        project.layers.push_back(other);
    });
    selection.setPhoto(document.project().layers[0].id);
    choose(Qt::Key_W);
    QTest::mouseClick(canvas, Qt::LeftButton, {}, placeOf(150, 150));
    ESM_EVENTUALLY(!edits.isWorking());
    ASSERT_TRUE(layer().preparation.whiteBalance);
    EXPECT_NEAR((*layer().preparation.whiteBalance)[0], 120.0 / 180, 0.01);
    ASSERT_EQ(dialog->findChild<QComboBox*>("whiteOthers")->currentText(), "other");
    dialog->findChild<QPushButton*>("whiteLike")->click();
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_NEAR((*layer().preparation.whiteBalance)[0], 200.0 / 180, 0.03);
}
