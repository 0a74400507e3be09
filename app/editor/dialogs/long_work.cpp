#include "app/editor/dialogs/long_work.h"

#include "app/editor/dialogs/key_window.h"

#include <QApplication>
#include <QDeadlineTimer>
#include <QEventLoop>
#include <QProgressDialog>
#include <QTimer>

#include <atomic>
#include <chrono>
#include <future>

namespace esm {

namespace {

/// Short work ends within it, so that no dialog flashes up.
constexpr std::chrono::milliseconds patience{200};
/// Most work is done sooner than events are worth looking at.
constexpr std::chrono::milliseconds blink{10};
constexpr std::chrono::milliseconds betweenLooks{5};

/// Keeps windows from being closed under the work's feet while no dialog stands before them.
class KeepsOpen : public QObject {
public:
    KeepsOpen() { qApp->installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::Close) return false;
        event->ignore();
        return true;
    }
};

/// The window draws and answers, but what the user does in it waits.
void waitBriefly(const std::function<bool()>& isDone) {
    const QDeadlineTimer deadline(patience);
    const KeepsOpen keepsOpen;
    QTimer poll;
    QEventLoop loop;
    QObject::connect(&poll, &QTimer::timeout, &loop, [&] {
        if (isDone() || deadline.hasExpired()) loop.quit();
    });
    poll.start(betweenLooks);
    loop.exec(QEventLoop::ExcludeUserInputEvents);
}

} // namespace

void runLongWork(QWidget* window, const QString& title, const std::function<void(const Progress&)>& work,
                 Cancelling cancelling) {
    std::atomic<int> permille = -1;
    std::atomic<bool> cancelled = false;
    auto done = std::async(std::launch::async, [&] {
        work([&](double fraction) {
            permille = static_cast<int>(fraction * 1000);
            return !cancelled;
        });
    });
    const auto isDone = [&] { return done.wait_for(std::chrono::seconds(0)) == std::future_status::ready; };
    if (done.wait_for(blink) != std::future_status::ready) waitBriefly(isDone);
    if (!isDone()) {
        const KeyWindow before(window);
        QProgressDialog dialog(
            title, cancelling == Cancelling::Impossible ? QString() : QObject::tr("Cancel"), 0, 0, window);
        dialog.setWindowTitle(title);
        dialog.setObjectName(QStringLiteral("progressDialog"));
        dialog.setWindowModality(Qt::ApplicationModal);
        dialog.setMinimumWidth(360);
        dialog.setAutoReset(false);
        dialog.setAutoClose(false);
        bool isInFront = QApplication::activeWindow() != nullptr;
        QTimer poll;
        QObject::connect(&poll, &QTimer::timeout, &dialog, [&] {
            isInFront = QApplication::activeWindow() != nullptr;
            if (isDone()) return dialog.done(0);
            if (cancelled) return dialog.setLabelText(QObject::tr("Stopping…"));
            if (permille < 0) return; // nothing was told yet
            dialog.setMaximum(1000);
            dialog.setValue(permille);
        });
        const auto cancel = [&] {
            if (!isDone()) cancelled = cancelling != Cancelling::Impossible;
        };
        QObject::connect(&dialog, &QProgressDialog::canceled, &dialog, cancel);
        // Escape reaches the cancel button only while the dialog is the active window.
        QObject::connect(&dialog, &QDialog::rejected, &dialog, cancel);
        poll.start(30);
        // Escape hides the dialog, but the work may take a moment to stop.
        while (!isDone())
            dialog.exec();
        // One who works in another program meanwhile keeps the keys.
        if (isInFront) before.activateAgain();
    }
    done.get();
    if (cancelled && cancelling == Cancelling::Offered) throw Cancelled();
}

} // namespace esm
