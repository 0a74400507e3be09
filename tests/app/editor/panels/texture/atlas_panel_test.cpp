#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QStandardItemModel>

using namespace esm;

namespace {

class AtlasPanelTest : public EditorTest {
protected:
    void SetUp() override { open(makeSample("tube")); }
};

/// A flat square of two triangles with texture coordinates of its own.
Project squareWithPlaces(const CornerCoordinates& second) {
    RepairedMesh surface;
    surface.mesh.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}};
    surface.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    surface.mesh.textureCoordinates = {{{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}}}, second};
    return makeProject("square", std::move(surface));
}

} // namespace

TEST_F(AtlasPanelTest, ForgetsThatThereWasNoSurface) {
    Project bare = makeSample("tube");
    auto mesh = std::make_shared<TriangleMesh>(*bare.mesh);
    mesh->triangles.clear();
    bare.mesh = mesh;
    bare.atlas.reset();
    auto* size = child<QComboBox>("atlasSize");
    window->document().replace(bare, std::nullopt);
    EXPECT_FALSE(size->isEnabled());
    const QString why = size->toolTip();
    Project good = makeSample("tube");
    good.texture.atlas.size = 3000;
    window->document().replace(good, std::nullopt);
    EXPECT_TRUE(size->isEnabled());
    EXPECT_NE(size->toolTip(), why);
    EXPECT_TRUE(size->currentText().startsWith("3000")) << "a size that is not in the list is shown";
}

TEST_F(AtlasPanelTest, PacksInTheLayoutThatIsChosen) {
    auto* layout = child<QComboBox>("atlasLayout");
    EXPECT_EQ(layout->currentText(), "matched rows");
    const auto choose = [&](const char* name) {
        layout->setCurrentText(name);
        emit layout->activated(layout->currentIndex());
        return window->document().project().atlas->utilisation;
    };
    const double inRows = choose("rows");
    EXPECT_GT(choose("matched rows"), inRows);
    EXPECT_EQ(child<QLabel>("atlasSeams")->text(), "100 % of edges");
    choose("unfolded groups");
    EXPECT_NE(child<QLabel>("atlasSeams")->text(), "100 % of edges");
    EXPECT_EQ(child<QLabel>("atlasDistortion")->text(), "none");
    choose("charts");
    EXPECT_TRUE(child<QLabel>("atlasDistortion")->text().contains(", up to 1."));
    window->document().undoStack()->undo();
    window->document().undoStack()->undo();
    window->document().undoStack()->undo();
    EXPECT_EQ(layout->currentText(), "rows");
    EXPECT_EQ(window->document().project().atlas->utilisation, inRows);
}

TEST_F(AtlasPanelTest, TakesTheLayoutThatTheMeshBrought) {
    open(squareWithPlaces({{{0.25, 0.25}, {0.75, 0.75}, {0.25, 0.75}}}));
    auto* layout = child<QComboBox>("atlasLayout");
    layout->setCurrentText("the mesh's own");
    emit layout->activated(layout->currentIndex());
    EXPECT_EQ(window->document().project().atlas->options.layout, AtlasLayout::Own);
    EXPECT_EQ(child<QLabel>("atlasUsed")->text(), "25 %");
    EXPECT_EQ(child<QLabel>("atlasSeams")->text(), "0.0 % of edges");
    EXPECT_TRUE(child<QLabel>("atlasFlaws")->isHidden());
    EXPECT_EQ(child<QLabel>("atlasDistortion")->text(), "1.00, up to 1.00");
    EXPECT_FALSE(child<QCheckBox>("atlasFills")->isEnabled());
    window->document().undoStack()->undo();
    EXPECT_EQ(layout->currentText(), "matched rows");
}

TEST_F(AtlasPanelTest, OffersNoLayoutOfItsOwnWhereTheMeshBroughtNone) {
    const auto isOffered = [this] {
        const auto* layout = child<QComboBox>("atlasLayout");
        const auto* entries = qobject_cast<const QStandardItemModel*>(layout->model());
        return entries->item(layout->findText("the mesh's own"))->isEnabled();
    };
    EXPECT_FALSE(isOffered());
    open(squareWithPlaces({{{0.25, 0.25}, {0.75, 0.75}, {0.25, 0.75}}}));
    EXPECT_TRUE(isOffered());
}

TEST_F(AtlasPanelTest, OffersToPackAnewWhatCannotBePainted) {
    Project asked = squareWithPlaces({{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}}});
    asked.texture.atlas.texelsPerMetre = 1000;
    open(asked);
    auto* layout = child<QComboBox>("atlasLayout");
    const auto choose = [&](const QString& answer) {
        dialogs.expectNamed("ownLayoutBox", [&](QDialog* dialog) {
            auto* box = qobject_cast<QMessageBox*>(dialog);
            EXPECT_TRUE(box->informativeText().contains("lie over each other"))
                << box->informativeText().toStdString();
            for (QAbstractButton* button : box->buttons())
                if (button->text().remove('&') == answer) button->click();
        });
        layout->setCurrentText("the mesh's own");
        emit layout->activated(layout->currentIndex());
        EXPECT_TRUE(dialogs.isDone());
    };
    choose("Cancel");
    EXPECT_FALSE(window->document().project().atlas);
    EXPECT_EQ(layout->currentText(), "matched rows");
    choose("Pack in matched rows");
    ASSERT_TRUE(window->document().project().atlas);
    EXPECT_EQ(window->document().project().atlas->options.layout, AtlasLayout::MatchedRows);
    EXPECT_EQ(window->document().project().atlas->texelsPerMetre, 1000) << "as was asked before";
}

TEST_F(AtlasPanelTest, HasAsManyPagesAsTheTexelTakes) {
    const auto atlas = [this] { return window->document().project().atlas; };
    auto* size = child<QComboBox>("atlasSize");
    size->setCurrentText("512 × 512");
    emit size->activated(size->currentIndex());
    const double filled = atlas()->texelsPerMetre;
    ASSERT_EQ(atlas()->options.pages, 1);
    auto* texel = child<NumberField>("atlasTexel");
    auto* fills = child<QCheckBox>("atlasFills");
    EXPECT_NEAR(*texel->value(), 1 / filled, 1e-3 / filled);
    EXPECT_TRUE(fills->isChecked());
    emit texel->valueEdited(1 / (2 * filled));
    EXPECT_NEAR(atlas()->texelsPerMetre, 2 * filled, 1e-6 * filled);
    EXPECT_GE(atlas()->options.pages, 4);
    EXPECT_EQ(child<QLabel>("atlasPages")->text(), QString::number(atlas()->options.pages));
    EXPECT_FALSE(fills->isChecked());
    fills->click();
    EXPECT_EQ(atlas()->options.pages, 1);
    EXPECT_NEAR(atlas()->texelsPerMetre, filled, 0.02 * filled);
    window->document().undoStack()->undo();
    EXPECT_NEAR(atlas()->texelsPerMetre, 2 * filled, 1e-6 * filled);
    EXPECT_FALSE(fills->isChecked());
    DialogScript script;
    script.expectButton("problemBox", QMessageBox::Ok);
    emit texel->valueEdited(1e-7);
    EXPECT_TRUE(script.isDone());
    EXPECT_NEAR(atlas()->texelsPerMetre, 2 * filled, 1e-6 * filled) << "what cannot be packed stays undone";
    EXPECT_NEAR(*texel->value(), 1 / (2 * filled), 1e-3 / filled);
}
