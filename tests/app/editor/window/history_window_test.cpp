#include "app/editor/window/history_window.h"

#include "core/authoring/regions.h"
#include "core/samples/samples.h"

#include <gtest/gtest.h>
#include <QTest>

using namespace esm;

namespace {

class HistoryWindowTest : public testing::Test {
protected:
    void setMass(double mass) {
        document.edit("mass " + QString::number(mass), [=](Project& project) { project.base.mass = mass; });
    }
    void SetUp() override { window.show(); }
    QListWidget& list() const { return *window.findChild<QListWidget*>("historyList"); }
    QStringList rows() const {
        QStringList texts;
        for (int row = 0; row < list().count(); ++row)
            texts << list().item(row)->text();
        return texts;
    }

    Document document{makeSample("tube")};
    HistoryWindow window{document};
};

} // namespace

TEST_F(HistoryWindowTest, ListsTheStepsAndMarksTheLastThatIsDone) {
    EXPECT_EQ(rows(), QStringList{"As it began"});
    setMass(2);
    setMass(3);
    EXPECT_EQ(rows(), (QStringList{"As it began", "mass 2", "mass 3"}));
    EXPECT_EQ(list().currentRow(), 2);
    document.undoStack()->undo();
    EXPECT_EQ(list().currentRow(), 1);
    EXPECT_EQ(rows().size(), 3) << "what can be redone stays";
    setMass(4);
    EXPECT_EQ(rows(), (QStringList{"As it began", "mass 2", "mass 4"}));
    document.replace(makeSample("tube"), std::nullopt);
    EXPECT_EQ(rows(), QStringList{"As it began"});
}

TEST_F(HistoryWindowTest, NamesTheRegionOrPhotoThatAStepIsAbout) {
    const RegionId tumour = document.newRegionId();
    document.edit("Add region", [=](Project& p) {
        addRegion(p, tumour, Eigen::Vector3d::Zero());
        partOf(p.regions, tumour).name = "Tumour";
    });
    document.edit("Soft rim", [=](Project& p) { partOf(p.regions, tumour).rim = 0.01; });
    document.edit("Rename region", [=](Project& p) { partOf(p.regions, tumour).name = "Cyst"; });
    document.edit("Soft rims", [](Project& p) {
        for (Region& region : p.regions)
            region.rim += 0.001;
    });
    document.edit("Remove region", [=](Project& p) { removeRegion(p, tumour); });
    setMass(2);
    EXPECT_EQ(rows().mid(1), (QStringList{"Add region · Tumour", "Soft rim · Tumour", "Rename region · Cyst",
                                          "Soft rims", "Remove region · Cyst", "mass 2"}));
}

TEST_F(HistoryWindowTest, SaysThatWhatIsLongPastIsGivenUp) {
    for (int i = 0; i <= Document::mostSteps; ++i)
        setMass(2 + i);
    EXPECT_EQ(list().count(), Document::mostSteps + 1);
    EXPECT_EQ(rows().first(), "Before the last 500 steps");
    list().setCurrentRow(0);
    EXPECT_EQ(document.project().base.mass, 2) << "not the first of all";
}

TEST_F(HistoryWindowTest, JumpsByKeyAndClick) {
    const double first = document.project().base.mass;
    for (const double mass : {2, 3, 4})
        setMass(mass);
    list().setCurrentRow(1);
    EXPECT_EQ(document.project().base.mass, 2);
    QTest::keyClick(&list(), Qt::Key_End);
    EXPECT_EQ(document.project().base.mass, 4);
    QTest::keyClick(&list(), Qt::Key_Home);
    EXPECT_EQ(document.project().base.mass, first);
    EXPECT_EQ(document.undoStack()->count(), 3) << "nothing is lost";
}
