#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>

using namespace esm;

namespace {

class AtlasPanelTest : public EditorTest {
protected:
    void SetUp() override { open(makeSample("tube")); }
};

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
    window->document().undoStack()->undo();
    window->document().undoStack()->undo();
    EXPECT_EQ(layout->currentText(), "rows");
    EXPECT_EQ(window->document().project().atlas->utilisation, inRows);
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
