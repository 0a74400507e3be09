#include "app/editor/commands/long_work.h"
#include "tests/app/editor_driver.h"

#include <chrono>
#include <thread>

using namespace esm;

namespace {

QPushButton* visibleButton(QDialog* dialog) {
    for (auto* button : dialog->findChildren<QPushButton*>())
        if (button->isVisible()) return button;
    return nullptr;
}

/// Half done, as long as nobody asks it to stop; a minute at most.
void endless(const Progress& progress) {
    for (int i = 0; i < 12000; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        reportProgress(progress, 0.5);
    }
}

} // namespace

TEST(LongWork, OffersCancelOnlyWhereItStops) {
    DialogScript dialogs;
    bool looked = false;
    dialogs.expectNamed("progressDialog", [&](QDialog* dialog) {
        looked = true;
        EXPECT_EQ(visibleButton(dialog), nullptr);
    });
    runLongWork(nullptr, "work",
                [&](const Progress&) { std::this_thread::sleep_for(std::chrono::milliseconds(600)); });
    EXPECT_TRUE(looked);
}

TEST(LongWork, GivesTheKeysBack) {
    QWidget window;
    QLineEdit field(&window);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    field.setFocus();
    runLongWork(&window, "work",
                [](const Progress&) { std::this_thread::sleep_for(std::chrono::milliseconds(1500)); });
    QTest::qWait(200);
    ESM_EVENTUALLY(QApplication::focusWidget() == &field);
}

TEST(LongWork, StopsWhenAsked) {
    DialogScript dialogs;
    dialogs.expectNamed("progressDialog", [](QDialog* dialog) {
        ASSERT_NE(visibleButton(dialog), nullptr);
        visibleButton(dialog)->click();
    });
    EXPECT_THROW(runLongWork(nullptr, "work", endless, Cancelling::Offered), Cancelled);
}

TEST(LongWork, StopsOnEscape) {
    DialogScript dialogs;
    dialogs.expectNamed("progressDialog", [](QDialog* dialog) { QTest::keyClick(dialog, Qt::Key_Escape); });
    EXPECT_THROW(runLongWork(nullptr, "work", endless, Cancelling::Offered), Cancelled);
}
