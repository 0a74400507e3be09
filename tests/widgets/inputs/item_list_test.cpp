#include "tests/support/eventually.h"
#include "widgets/inputs/item_list.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

using namespace esm;

namespace {

class ItemListTest : public testing::Test {
protected:
    void SetUp() override {
        list.setRows({{"Lobe", "212", Qt::red, {}, true}, {"Whole organ", "2 194", Qt::gray, {}, false}}, 0);
        list.resize(240, 100);
        list.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&list, patience));
        QApplication::setActiveWindow(&list);
        list.setFocus();
    }

    ItemList list{QPalette::Link};
};

} // namespace

TEST_F(ItemListTest, ShowsRowsWithoutAnnouncingThem) {
    QSignalSpy selected(&list, &ItemList::rowSelected), renamed(&list, &ItemList::rowRenamed);
    list.setRows({{"Other", "1", Qt::red, {}, true}}, -1);
    EXPECT_EQ(list.count(), 1);
    EXPECT_TRUE(list.selectedItems().isEmpty());
    EXPECT_EQ(selected.count() + renamed.count(), 0);
}

TEST_F(ItemListTest, ArrowsSelectAndDeleteAsksForRemoval) {
    QSignalSpy selected(&list, &ItemList::rowSelected), removed(&list, &ItemList::removeRequested);
    QTest::keyClick(&list, Qt::Key_Down);
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected[0][0].toInt(), 1);
    QTest::keyClick(&list, Qt::Key_Delete);
    ASSERT_EQ(removed.count(), 1);
    EXPECT_EQ(removed[0][0].toInt(), 1);
}

TEST_F(ItemListTest, F2RenamesWhatMayBeRenamed) {
    QSignalSpy renamed(&list, &ItemList::rowRenamed);
    QTest::keyClick(&list, Qt::Key_F2);
    auto* editor = list.findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->setText(" Right lobe ");
    QTest::keyClick(editor, Qt::Key_Return);
    ASSERT_TRUE(renamed.count() == 1 || renamed.wait(5000));
    EXPECT_EQ(renamed[0][1].toString(), "Right lobe");
    EXPECT_FALSE(list.item(1)->flags() & Qt::ItemIsEditable);
}

TEST_F(ItemListTest, CtrlAndArrowsAskForAnotherOrder) {
    QSignalSpy moved(&list, &ItemList::moveRequested), selected(&list, &ItemList::rowSelected);
    QTest::keyClick(&list, Qt::Key_Down, Qt::ControlModifier);
    ASSERT_EQ(moved.count(), 1);
    EXPECT_EQ(moved[0], (QList<QVariant>{0, 1}));
    EXPECT_EQ(list.currentRow(), 0) << "nothing has moved yet";
    list.setCurrentRow(1);
    QTest::keyClick(&list, Qt::Key_Up, Qt::ControlModifier);
    EXPECT_EQ(moved[1], (QList<QVariant>{1, 0}));
    EXPECT_EQ(selected.count(), 1);
}

TEST(RowAfterDrop, IsWhereTheLineWasShown) {
    EXPECT_EQ(rowAfterDrop(0, 2, DropPlace::Above), 1);
    EXPECT_EQ(rowAfterDrop(0, 2, DropPlace::Below), 2);
    EXPECT_EQ(rowAfterDrop(3, 1, DropPlace::Above), 1);
    EXPECT_EQ(rowAfterDrop(3, 1, DropPlace::Below), 2);
    EXPECT_EQ(rowAfterDrop(1, 1, DropPlace::Above), 1);
    EXPECT_EQ(rowAfterDrop(1, 1, DropPlace::Below), 1);
    EXPECT_EQ(rowAfterDrop(1, 0, DropPlace::Below), 1);
    EXPECT_EQ(rowAfterDrop(0, 2, DropPlace::On), 2);
    EXPECT_EQ(rowAfterDrop(2, 0, DropPlace::On), 0);
}

TEST_F(ItemListTest, KeepsTheSelectedRowInSightWhenItShrinks) {
    std::vector<ItemRow> rows(12, ItemRow{"Lobe", "", Qt::red, {}, true});
    list.resize(240, 500);
    list.setRows(rows, 11);
    list.resize(240, 100);
    EXPECT_TRUE(list.viewport()->rect().contains(list.visualItemRect(list.item(11))));
}

TEST_F(ItemListTest, ADragTakesNoRowAway) {
    EXPECT_EQ(list.model()->supportedDragActions(), Qt::CopyAction);
}

TEST_F(ItemListTest, ADropFromElsewhereIsNoRow) {
    QSignalSpy moved(&list, &ItemList::moveRequested);
    QMimeData data;
    const QPoint end = list.visualItemRect(list.item(1)).center();
    QDropEvent drop(end, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(list.viewport(), &drop);
    EXPECT_EQ(moved.count(), 0) << "what comes from elsewhere is no row";
    EXPECT_EQ(list.count(), 2);
}

TEST_F(ItemListTest, ItIsAsHighAsItsRowsAndMayBeLower) {
    EXPECT_EQ(list.sizeHint(), list.minimumSizeHint());
    list.setRows(std::vector<ItemRow>(20, {"Lobe", "212", Qt::red, {}, true}), 0);
    EXPECT_GT(list.sizeHint().height(), 2 * list.minimumSizeHint().height());
}

TEST_F(ItemListTest, AClickOnAnEyeSelectsNothing) {
    QSignalSpy eye(&list, &ItemList::eyeClicked), selected(&list, &ItemList::rowSelected);
    list.setRows({{"First", "", Qt::red, {}, true, true}, {"Second", "", Qt::red, {}, true, false}}, 0);
    EXPECT_TRUE(list.eyeRect(1).isValid());
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.eyeRect(1).center());
    QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, list.eyeRect(1).center());
    ASSERT_EQ(eye.count(), 2) << "the second click of a double one counts too";
    EXPECT_EQ(eye[0][0].toInt(), 1);
    EXPECT_EQ(selected.count(), 0);
    EXPECT_EQ(list.findChild<QLineEdit*>(), nullptr) << "nor does it rename";
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(1)).center());
    EXPECT_EQ(selected.count(), 1);
}

TEST_F(ItemListTest, RowsOfAnotherListHaveNoEye) {
    EXPECT_TRUE(list.eyeRect(0).isEmpty());
}
