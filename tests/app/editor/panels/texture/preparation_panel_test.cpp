#include "app/editor/panels/texture/preparation_panel.h"

#include "core/samples/samples.h"
#include "tests/support/eventually.h"

using namespace esm;

namespace {

Project withTwoPhotos() {
    Project project = makeSample("ventricle");
    project.layers.resize(2);
    numberByPlace(project.layers);
    for (TextureLayer& layer : project.layers)
        layer.photo = makeSamplePhoto("serosa");
    return project;
}

/// The panel alone, without its window.
class PreparationWarningTest : public testing::Test {
protected:
    PreparationWarningTest() : document(withTwoPhotos()) { select(0); }

    void select(std::size_t place) { selection.setPhoto(document.project().layers[place].id); }
    /// Keeps more of the photo than there is.
    void cropTooMuch() {
        edits.edit("Crop", [](PreparationWish& wish) { wish.preparation.crop = PhotoCrop{0, 0, 99999, 9}; });
    }
    /// Empty where there is no warning.
    QString warning() const {
        const auto* label = panel.findChild<QLabel*>("preparationWarning");
        EXPECT_EQ(label->isHidden(), label->text().isEmpty());
        return label->text();
    }

    Document document;
    Selection& selection = *new Selection(document);
    PreparationEdits& edits = *new PreparationEdits(document, selection);
    PreparationPanel panel{edits};
};

} // namespace

TEST_F(PreparationWarningTest, SaysWhyAPhotoIsNotPrepared) {
    EXPECT_EQ(warning(), "");
    cropTooMuch();
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_TRUE(warning().startsWith("Not prepared: ")) << warning().toStdString();
    EXPECT_TRUE(warning().contains("crop")) << warning().toStdString();
    edits.edit("Even light", [](PreparationWish& wish) { wish.preparation.evenLight = 0.5; });
    EXPECT_EQ(warning(), "");
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(warning(), "");
}

TEST_F(PreparationWarningTest, IsOfItsOwnPhotoOnly) {
    cropTooMuch();
    select(1);
    ESM_EVENTUALLY(!edits.isWorking());
    EXPECT_EQ(warning(), "");
    select(0);
    EXPECT_TRUE(warning().contains("crop")) << warning().toStdString();
}
