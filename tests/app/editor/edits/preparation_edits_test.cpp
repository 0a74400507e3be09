#include "app/editor/edits/preparation_edits.h"

#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QCheckBox>
#include <QLabel>

using namespace esm;

namespace {

/// A bright disc in black, or a plain photo where the radius is zero.
std::shared_ptr<const Photo> drawnPhoto(double radius) {
    auto photo = std::make_shared<Photo>();
    photo->fileName = "disc.png";
    photo->image.width = 200;
    photo->image.height = 160;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) {
            const bool inside = radius == 0 || std::hypot(x + 0.5 - 100, y + 0.5 - 80) < radius;
            const int level = inside ? 120 + x / 4 : 0;
            for (const int channel : {level, level / 3, level / 4, 255})
                photo->image.pixels.push_back(static_cast<std::uint8_t>(channel));
        }
    return photo;
}

Project withLayers(std::initializer_list<double> radii) {
    Project project = makeSample("ventricle");
    for (const double radius : radii) {
        TextureLayer layer;
        layer.name = "disc";
        layer.photo = drawnPhoto(radius);
        project.layers.push_back(layer);
    }
    return project;
}

struct Editing {
    explicit Editing(Project project) : document(std::move(project)) {
        selection.setPhoto(document.project().layers[0].id);
    }

    const TextureLayer& layer(std::size_t i = 0) const { return document.project().layers[i]; }
    void evenLight(double strength) {
        edits.edit(
            "Even light", [=](PreparationWish& wish) { wish.preparation.evenLight = strength; },
            EditKind::EvenLight);
    }
    void findField() {
        edits.edit("Mask", [](PreparationWish& wish) { wish.find.field = true; });
    }

    Document document;
    Selection& selection = *new Selection(document);
    PreparationEdits& edits = *new PreparationEdits(document, selection);
};

} // namespace

TEST(PreparationEdits, ComeWithTheirPictureAsOneStep) {
    Editing editing(withLayers({60}));
    editing.findField();
    EXPECT_TRUE(editing.edits.isWorking());
    EXPECT_TRUE(editing.edits.wanted().find.field);
    EXPECT_FALSE(editing.layer().preparation.field) << "the window does not wait for it";
    ESM_EVENTUALLY(!editing.edits.isWorking());
    ASSERT_TRUE(editing.layer().preparation.field);
    EXPECT_NEAR(editing.layer().preparation.field->radii.x(), 60, 1);
    ASSERT_TRUE(editing.layer().prepared);
    EXPECT_EQ(editing.layer().prepared->at(0, 0)[3], 0);
    ASSERT_NE(editing.edits.shown(), nullptr);
    EXPECT_FALSE(editing.edits.shown()->after.isNull());
    EXPECT_EQ(editing.document.undoStack()->count(), 1);
    editing.document.undoStack()->undo();
    EXPECT_EQ(editing.layer().prepared, nullptr);
    EXPECT_TRUE(editing.layer().preparation.isNothing());
}

TEST(PreparationEdits, OfOneDragAreOneStep) {
    Editing editing(withLayers({60}));
    for (int i = 1; i <= 20; ++i) {
        editing.evenLight(i / 20.0);
        if (i % 6 == 0) {
            ESM_EVENTUALLY(!editing.edits.isWorking());
        }
    }
    editing.edits.finishGesture();
    editing.evenLight(0.25);
    ESM_EVENTUALLY(!editing.edits.isWorking());
    EXPECT_EQ(editing.layer().preparation.evenLight, 0.25);
    EXPECT_EQ(editing.document.undoStack()->count(), 2);
    editing.document.undoStack()->undo();
    EXPECT_EQ(editing.layer().preparation.evenLight, 1);
    editing.document.undoStack()->undo();
    EXPECT_EQ(editing.layer().preparation.evenLight, 0);
}

TEST(PreparationEdits, ThatAreAskedForAtOnceAllHappenInOrder) {
    Editing editing(withLayers({60, 50}));
    editing.findField();
    editing.evenLight(0.5);
    editing.selection.setPhoto(editing.document.project().layers[1].id);
    editing.findField();
    ESM_EVENTUALLY(!editing.edits.isWorking());
    EXPECT_EQ(editing.document.undoStack()->count(), 3);
    EXPECT_TRUE(editing.layer(0).preparation.field);
    EXPECT_EQ(editing.layer(0).preparation.evenLight, 0.5);
    ASSERT_TRUE(editing.layer(1).preparation.field);
    EXPECT_NEAR(editing.layer(1).preparation.field->radii.x(), 50, 1);
    EXPECT_EQ(editing.layer(1).preparation.evenLight, 0);
}

TEST(PreparationEdits, SayWhatIsNotFoundAndChangeNothing) {
    Editing editing(withLayers({0}));
    editing.findField();
    ESM_EVENTUALLY(!editing.edits.isWorking());
    EXPECT_TRUE(editing.edits.missing().field);
    EXPECT_EQ(editing.document.undoStack()->count(), 0);
    EXPECT_EQ(editing.layer().prepared, nullptr);
}

TEST(PreparationEdits, OfAPhotoThatIsGoneAreDropped) {
    Editing editing(withLayers({60}));
    editing.findField();
    editing.evenLight(0.5);
    editing.document.edit("Remove", [](Project& project) { project.layers.clear(); });
    ESM_EVENTUALLY(!editing.edits.isWorking());
    EXPECT_TRUE(editing.document.project().layers.empty());
    EXPECT_EQ(editing.document.undoStack()->count(), 1);
}

TEST(PreparationEdits, ThatCannotBeMadeSayWhy) {
    Editing editing(withLayers({60}));
    editing.edits.edit("Crop", [](PreparationWish& wish) {
        wish.preparation.crop = PhotoCrop{0, 0, 999, 9};
    });
    ESM_EVENTUALLY(!editing.edits.isWorking());
    EXPECT_TRUE(editing.edits.failure().contains("crop")) << editing.edits.failure().toStdString();
    EXPECT_EQ(editing.document.undoStack()->count(), 0);
    editing.evenLight(0.5);
    EXPECT_EQ(editing.edits.failure(), "") << "another edit may do";
}

TEST(PreparationEdits, ThatFailAreToldOfTheirOwnPhoto) {
    Editing editing(withLayers({60, 50}));
    editing.edits.edit("Crop", [](PreparationWish& wish) {
        wish.preparation.crop = PhotoCrop{0, 0, 999, 9};
    });
    editing.selection.setPhoto(editing.document.project().layers[1].id);
    editing.evenLight(0.5);
    ESM_EVENTUALLY(!editing.edits.isWorking());
    EXPECT_EQ(editing.edits.failure(), "");
    editing.selection.setPhoto(editing.document.project().layers[0].id);
    EXPECT_TRUE(editing.edits.failure().contains("crop")) << "edits of other photos do not take it back";
    editing.document.edit("Even light",
                          [](Project& project) { project.layers[0].preparation.evenLight = 0.1; });
    EXPECT_EQ(editing.edits.failure(), "") << "it is another preparation that is shown";
}

class PreparationPanelTest : public EditorTest {};

TEST_F(PreparationPanelTest, AClickPreparesThePhotoAndSaysWhatWasFound) {
    open(withLayers({60}));
    window->windowActions().texture->trigger();
    auto* field = child<QCheckBox>("roundField");
    ESM_EVENTUALLY(field->isVisible() && field->isEnabled());
    const int height = settledHeight(field->parentWidget());
    field->click();
    ESM_EVENTUALLY(child<QLabel>("roundFieldWords")->text() == "circle");
    EXPECT_TRUE(field->isChecked());
    child<QCheckBox>("evenLight")->click();
    ESM_EVENTUALLY(project().layers[0].preparation.evenLight == 0.7);
    EXPECT_EQ(child<NumberField>("evenLightStrength")->value(), 0.7);
    child<QCheckBox>("highlights")->click();
    ESM_EVENTUALLY(child<QLabel>("highlightsWords")->text() == "none found");
    EXPECT_EQ(settledHeight(field->parentWidget()), height) << "nothing jumps";
    for (int step = 0; step < 3; ++step)
        window->document().undoStack()->undo();
    EXPECT_FALSE(field->isChecked());
    EXPECT_FALSE(child<QCheckBox>("crop")->isEnabled()) << "there is no crop to bring back";
}
