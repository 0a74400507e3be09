#include "app/editor/dialogs/import_dialog.h"

#include "widgets/inputs/number_field.h"

#include <gtest/gtest.h>
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>

using namespace esm;

namespace {

ImportedSurface threeParts() {
    ImportedSurface surface;
    surface.extent = {200, 100, 100};
    surface.vertices = 6000;
    surface.parts = {{900, {50, 40, 30}}, {20, {10, 10, 5}}, {1, {1, 1, 0}}};
    surface.report.warnings = {"three parts"};
    return surface;
}

ImportedSurface largestOf(const ImportedSurface& surface) {
    ImportedSurface largest;
    largest.parts = {surface.parts.front()};
    largest.extent = largest.parts.front().extent;
    largest.vertices = 900;
    return largest;
}

class ImportDialogTest : public testing::Test {
protected:
    QString reported() const { return dialog.findChild<QPlainTextEdit*>("importReport")->toPlainText(); }

    ImportDialog dialog{"organ.obj", threeParts(), largestOf(threeParts())};
    QComboBox* keep = dialog.findChild<QComboBox*>("importKeep");
};

} // namespace

TEST_F(ImportDialogTest, ShowsTheSizeOfWhatIsKept) {
    const auto* size = dialog.findChild<QLabel*>("importSize");
    EXPECT_EQ(size->text(), "200 × 100 × 100 mm");
    keep->setCurrentIndex(1);
    EXPECT_EQ(size->text(), "50 × 40 × 30 mm");
    EXPECT_FALSE(reported().contains("three parts"));
    for (const auto* choice : dialog.findChildren<QComboBox*>())
        EXPECT_FALSE(choice->accessibleName().isEmpty());
}

TEST_F(ImportDialogTest, DoubtsASizeNoOrganHasWithoutAJump) {
    const auto* doubt = dialog.findChild<QLabel*>("importDoubt");
    EXPECT_EQ(doubt->text(), "");
    const int height = dialog.sizeHint().height();
    dialog.findChild<QAbstractButton*>("unit2")->click();
    EXPECT_TRUE(doubt->text().contains("200 mm in millimetres")) << doubt->text().toStdString();
    EXPECT_EQ(dialog.sizeHint().height(), height);
    EXPECT_TRUE(doubtfulExtent(1e-9, LengthUnit::Metre).contains("no unit"));
}

TEST_F(ImportDialogTest, SaysWhatAnOpenBorderMeans) {
    EXPECT_FALSE(reported().contains("3 mm"));
    ImportedSurface open = largestOf(threeParts());
    open.report.boundaryEdges = 240;
    ImportDialog other("open.obj", open, std::nullopt);
    EXPECT_TRUE(other.findChild<QPlainTextEdit*>("importReport")->toPlainText().contains("3 mm"));
}

TEST_F(ImportDialogTest, ListsThePartsWithTheirSizes) {
    EXPECT_EQ(keep->itemText(0), "all 3 parts");
    EXPECT_EQ(keep->itemText(1), "the largest part: 900 triangles");
    EXPECT_TRUE(reported().contains("1: 900 triangles, 50 × 40 × 30 mm"));
    EXPECT_TRUE(reported().contains("2: 20 triangles, 10 × 10 × 5.0 mm"));
    EXPECT_TRUE(reported().contains("3: 1 triangle,"));
    dialog.findChild<QAbstractButton*>("unit1")->click();
    EXPECT_TRUE(reported().contains("1: 900 triangles, 500 × 400 × 300 mm"));
}

TEST_F(ImportDialogTest, AsksHowMuchIsSimulated) {
    auto* detail = dialog.findChild<QComboBox*>("importDetail");
    auto* nodes = dialog.findChild<NumberField*>("numberField");
    EXPECT_EQ(dialog.choice().detail.kind, Detail::Kind::EveryVertex);
    EXPECT_EQ(nodes->value(), 6000);
    EXPECT_FALSE(nodes->isEnabled());
    detail->setCurrentIndex(1);
    EXPECT_TRUE(nodes->isEnabled());
    EXPECT_EQ(dialog.choice().detail.kind, Detail::Kind::Nodes);
    EXPECT_EQ(dialog.choice().detail.nodes, 2000U);
    keep->setCurrentIndex(1); // there are not as many vertices
    EXPECT_EQ(dialog.choice().detail.nodes, 900U);
    keep->setCurrentIndex(0);
    EXPECT_EQ(dialog.choice().detail.nodes, 2000U);
    detail->setCurrentIndex(2);
    EXPECT_EQ(dialog.choice().detail.kind, Detail::Kind::Rigid);
    EXPECT_EQ(nodes->value(), 8);
    EXPECT_FALSE(nodes->isEnabled());
}
