#include "app/editor/panels/texture/photos_panel.h"

#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QContextMenuEvent>
#include <QMenu>

#include <stdexcept>

using namespace esm;

namespace {

class PhotosPanelTest : public EditorTest {
protected:
    void SetUp() override {
        Project organ = makeSample("tube");
        organ.layers.clear();
        for (const char* name : {"lower", "middle", "upper"}) {
            TextureLayer layer;
            layer.name = name;
            layer.photo = makeSamplePhoto("serosa");
            organ.layers.push_back(layer);
        }
        open(std::move(organ));
        press(Qt::Key_2, Qt::ControlModifier);
        list = child<ItemList>("photoList");
        ASSERT_TRUE(list->isVisible());
    }
    void openMenu(int row, const std::function<void(QMenu*)>& use) const {
        const QPoint place = list->visualItemRect(list->item(row)).center();
        QTest::mouseClick(list->viewport(), Qt::RightButton, {}, place);
        QTimer::singleShot(50, list, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            ASSERT_NE(menu, nullptr);
            use(menu);
            menu->close();
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, list->viewport()->mapToGlobal(place));
        QApplication::sendEvent(list->viewport(), &event);
    }
    static QAction* entryOf(QMenu* menu, const QString& text) {
        for (QAction* action : menu->actions())
            if (plainText(action) == text) return action;
        throw std::out_of_range("no entry says " + text.toStdString());
    }
    static void trigger(QMenu* menu, const QString& text) { entryOf(menu, text)->trigger(); }

    ItemList* list = nullptr;
};

} // namespace

TEST_F(PhotosPanelTest, EyesHideAndShow) {
    list->setCurrentRow(0);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->eyeRect(1).center());
    EXPECT_FALSE(project().layers[1].visible);
    EXPECT_EQ(list->currentRow(), 0);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->eyeRect(1).center());
    EXPECT_TRUE(project().layers[1].visible);
    EXPECT_EQ(window->document().undoStack()->count(), 2);
}

TEST_F(PhotosPanelTest, TheMenuActsOnItsRow) {
    openMenu(1, [](QMenu* menu) { trigger(menu, "Duplicate photo"); });
    ASSERT_EQ(project().layers.size(), 4U);
    EXPECT_EQ(project().layers[2].name, "middle copy");
    EXPECT_EQ(list->currentRow(), 1) << "the copy is selected";
    openMenu(2, [](QMenu* menu) { trigger(menu, "Hide or show photo"); });
    EXPECT_FALSE(project().layers[1].visible);
    openMenu(3, [](QMenu* menu) { trigger(menu, "Move up"); });
    EXPECT_EQ(project().layers[1].name, "lower");
    openMenu(0, [](QMenu* menu) {
        EXPECT_FALSE(entryOf(menu, "Move up")->isEnabled());
        trigger(menu, "Remove");
    });
    EXPECT_EQ(project().layers.size(), 3U);
    window->document().undoStack()->undo();
    EXPECT_EQ(project().layers.size(), 4U);
}

TEST_F(PhotosPanelTest, TheMenuRenames) {
    openMenu(1, [](QMenu* menu) { trigger(menu, "Rename"); });
    EXPECT_NE(list->findChild<QLineEdit*>(), nullptr);
}

TEST_F(PhotosPanelTest, ManyRowsAreSeenAtOnce) {
    window->document().edit("add", [&](Project& edited) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            edited.layers.push_back(edited.layers[0]);
            edited.layers.back().id = {100 + i};
        }
    });
    window->resize(1440, 900);
    ESM_EVENTUALLY(list->viewport()->rect().contains(list->visualItemRect(list->item(6))));
}
