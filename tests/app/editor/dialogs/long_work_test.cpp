#include "app/editor/dialogs/long_work.h"
#include "tests/app/editor_driver.h"

#include <future>
#include <thread>

using namespace esm;

namespace {

QPushButton* visibleButton(QDialog* dialog) {
    for (auto* button : dialog->findChildren<QPushButton*>())
        if (button->isVisible()) return button;
    return nullptr;
}

/// Half done, as long as nobody asks it to stop.
void endless(const Progress& progress) {
    for (;;) {
        reportProgress(progress, 0.5);
        std::this_thread::yield();
    }
}

} // namespace

TEST(LongWork, OffersCancelOnlyWhereItStops) {
    DialogScript dialogs;
    std::promise<void> looked;
    dialogs.expectNamed("progressDialog", [&](QDialog* dialog) {
        EXPECT_EQ(visibleButton(dialog), nullptr);
        looked.set_value();
    });
    runLongWork(nullptr, "work", [&](const Progress&) { looked.get_future().wait(); });
    EXPECT_TRUE(dialogs.isDone());
}

TEST(LongWork, GivesTheKeysBackToTheWindowThatHadThem) {
    QWidget main, window;
    main.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&main, patience));
    QLineEdit field(&window);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, patience));
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, patience));
    field.setFocus();
    DialogScript dialogs;
    std::promise<void> dialogHasTheKeys;
    dialogs.expectNamed("progressDialog", [&](QDialog* dialog) {
        EXPECT_TRUE(QTest::qWaitForWindowActive(dialog, patience));
        dialogHasTheKeys.set_value();
    });
    runLongWork(&main, "work", [&](const Progress&) { dialogHasTheKeys.get_future().wait(); });
    EXPECT_TRUE(dialogs.isDone());
    ESM_EVENTUALLY(QApplication::activeWindow() == &window && QApplication::focusWidget() == &field);
}

TEST(LongWork, GivesTheKeysToItsWindowWhereTheOneThatHadThemIsGone) {
    QWidget main, window;
    for (QWidget* shown : {&main, &window}) {
        shown->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(shown, patience));
    }
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, patience));
    DialogScript dialogs;
    std::promise<void> isGone;
    dialogs.expectNamed("progressDialog", [&](QDialog* dialog) {
        EXPECT_TRUE(QTest::qWaitForWindowActive(dialog, patience));
        window.hide();
        isGone.set_value();
    });
    runLongWork(&main, "work", [&](const Progress&) { isGone.get_future().wait(); });
    ESM_EVENTUALLY(QApplication::activeWindow() == &main);
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

TEST(LongWork, WasCancelledOnceAskedThoughItWasDoneFirst) {
    for (const Cancelling cancelling : {Cancelling::Offered, Cancelling::UntilDone}) {
        DialogScript dialogs;
        std::promise<void> asked;
        dialogs.expectNamed("progressDialog", [&](QDialog* dialog) {
            visibleButton(dialog)->click();
            asked.set_value();
        });
        const auto run = [&] {
            runLongWork(
                nullptr, "work", [&](const Progress&) { asked.get_future().wait(); }, cancelling);
        };
        if (cancelling == Cancelling::Offered)
            EXPECT_THROW(run(), Cancelled);
        else
            EXPECT_NO_THROW(run()) << "the file is there";
    }
}
