#include "app/editor/dialogs/long_work.h"

#include <QApplication>
#include <QProgressDialog>
#include <QTimer>

#include <atomic>
#include <chrono>
#include <future>

namespace esm {

namespace {

/// Short work ends within it, so that no dialog flashes up.
constexpr std::chrono::milliseconds patience{200};

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
    if (done.wait_for(patience) != std::future_status::ready) {
        QProgressDialog dialog(title, cancelling == Cancelling::Offered ? QObject::tr("Cancel") : QString(),
                               0, 0, window);
        dialog.setWindowTitle(title);
        dialog.setObjectName(QStringLiteral("progressDialog"));
        dialog.setWindowModality(Qt::ApplicationModal);
        dialog.setMinimumWidth(360);
        dialog.setAutoReset(false);
        dialog.setAutoClose(false);
        bool isInFront = window && window->isActiveWindow();
        QTimer poll;
        QObject::connect(&poll, &QTimer::timeout, &dialog, [&] {
            isInFront = QApplication::activeWindow() != nullptr;
            if (isDone()) return dialog.done(0);
            if (cancelled) return dialog.setLabelText(QObject::tr("Stopping…"));
            if (permille < 0) return;
            dialog.setMaximum(1000);
            dialog.setValue(permille);
        });
        const auto cancel = [&] {
            if (!isDone()) cancelled = cancelling == Cancelling::Offered;
        };
        QObject::connect(&dialog, &QProgressDialog::canceled, &dialog, cancel);
        // Escape reaches the cancel button only while the dialog is the active window.
        QObject::connect(&dialog, &QDialog::rejected, &dialog, cancel);
        poll.start(30);
        // Escape hides the dialog, but the work may take a moment to stop.
        while (!isDone())
            dialog.exec();
        // Where a dialog goes, not every desktop gives the keys back; one who works elsewhere meanwhile keeps
        // them.
        if (window && isInFront) window->activateWindow();
    }
    done.get();
    if (cancelled) throw Cancelled();
}

} // namespace esm
