#include "app/editor/edits/preparation_session.h"

#include "core/samples/samples.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

Project withTwoPhotos() {
    Project project = makeSample("ventricle");
    for (const char* name : {"first", "second"}) {
        auto photo = std::make_shared<Photo>();
        photo->fileName = name;
        photo->image = {40, 30, std::vector<std::uint8_t>(4 * 40 * 30, 200)};
        TextureLayer layer;
        layer.name = name;
        layer.photo = photo;
        project.layers.push_back(layer);
    }
    return project;
}

class PreparationSessionTest : public testing::Test {
protected:
    PreparationSessionTest() : document(withTwoPhotos()) { select(0); }

    void select(std::size_t layer) { selection.setPhoto(document.project().layers[layer].id); }
    const TextureLayer& layer(std::size_t place) const { return document.project().layers[place]; }
    void crop(int width) {
        edits.edit("Crop", [=](PreparationWish& wish) { wish.preparation.crop = PhotoCrop{0, 0, width, 9}; });
        ESM_EVENTUALLY(!edits.isWorking());
    }
    void setOpacity(double opacity) {
        document.edit("Opacity", [=](Project& project) { project.layers[0].opacity = opacity; });
    }
    int cropOf(std::size_t place) const {
        return layer(place).preparation.crop ? layer(place).preparation.crop->width : 0;
    }

    Document document;
    Selection& selection = *new Selection(document);
    PreparationEdits& edits = *new PreparationEdits(document, selection);
};

} // namespace

TEST_F(PreparationSessionTest, UndoesNothingFromBeforeItBegan) {
    crop(10);
    PreparationSession session(document, edits);
    EXPECT_FALSE(session.canUndo());
    crop(11);
    EXPECT_TRUE(session.canUndo());
    session.undo();
    EXPECT_FALSE(session.canUndo());
    session.undo();
    EXPECT_EQ(cropOf(0), 10);
}

TEST_F(PreparationSessionTest, RedoesOnlyWhatItUndid) {
    crop(10);
    document.undoStack()->undo();
    PreparationSession session(document, edits);
    EXPECT_FALSE(session.canRedo());
    crop(11);
    session.undo();
    EXPECT_TRUE(session.canRedo());
    session.redo();
    EXPECT_EQ(cropOf(0), 11);
    EXPECT_FALSE(session.canRedo());
}

TEST_F(PreparationSessionTest, LeavesStepsOfAnotherKindAlone) {
    PreparationSession session(document, edits);
    crop(11);
    setOpacity(0.5);
    EXPECT_FALSE(session.canUndo());
    session.undo();
    EXPECT_EQ(layer(0).opacity, 0.5);
    document.undoStack()->undo();
    EXPECT_TRUE(session.canUndo());
    EXPECT_FALSE(session.canRedo());
}

TEST_F(PreparationSessionTest, PutsEveryPhotoBackAndLeavesNoStep) {
    crop(10);
    PreparationSession session(document, edits);
    crop(11);
    select(1);
    crop(12);
    EXPECT_TRUE(session.isChanged());
    session.putBack();
    EXPECT_EQ(cropOf(0), 10);
    EXPECT_EQ(cropOf(1), 0);
    EXPECT_FALSE(session.isChanged());
    EXPECT_EQ(document.undoStack()->index(), 1);
    EXPECT_TRUE(document.undoStack()->canRedo());
}

TEST_F(PreparationSessionTest, PutsBackAsOneStepWhereMoreWasDoneMeanwhile) {
    PreparationSession session(document, edits);
    crop(11);
    setOpacity(0.5);
    crop(12);
    session.putBack();
    EXPECT_EQ(cropOf(0), 0);
    EXPECT_FALSE(layer(0).prepared);
    EXPECT_EQ(layer(0).opacity, 0.5);
    EXPECT_EQ(document.undoStack()->count(), 4);
    document.undoStack()->undo();
    EXPECT_EQ(cropOf(0), 12);
}

TEST_F(PreparationSessionTest, BeginsWhereTheWindowWentBackTo) {
    crop(10);
    crop(11);
    PreparationSession session(document, edits);
    document.goTo(1);
    EXPECT_FALSE(session.canUndo());
    EXPECT_FALSE(session.canRedo());
    crop(12);
    session.undo();
    session.undo();
    EXPECT_EQ(cropOf(0), 10);
}

TEST_F(PreparationSessionTest, PutsBackMoreStepsThanTheUndoListHolds) {
    crop(10);
    PreparationSession session(document, edits);
    for (int i = 0; i <= Document::mostSteps; ++i)
        document.edit("Crop", [=](Project& project) {
            project.layers[0].preparation.crop = PhotoCrop{0, 0, 11 + i % 2, 9};
        });
    session.putBack();
    EXPECT_EQ(cropOf(0), 10);
}

TEST_F(PreparationSessionTest, UndoDropsAnEditThatWaits) {
    PreparationSession session(document, edits);
    crop(10);
    edits.edit("Crop", [](PreparationWish& wish) { wish.preparation.crop = PhotoCrop{0, 0, 11, 9}; });
    edits.edit("Crop", [](PreparationWish& wish) { wish.preparation.crop = PhotoCrop{0, 0, 12, 9}; });
    session.undo();
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(cropOf(0), 11);
    EXPECT_EQ(document.undoStack()->count(), 2);
}
