#pragma once

#include "core/support/progress.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <optional>

namespace esm {

enum class Cancelling {
    Offered,   ///< of what is done too soon to be stopped nothing is taken
    UntilDone, ///< the work leaves a file, which stays where it was done too soon to be stopped
    Impossible
};

/// Does long work on another thread while the window stays alive; after a moment a dialog with progress
/// appears, with a cancel button where it is offered: for work that looks at its Progress often enough to
/// stop at once. Returns when the work is done and passes on what it throws; Cancelled when it was asked to
/// stop. Where the dialog was in front, the window that had the keys has them again.
void runLongWork(QWidget* window, const QString& title, const std::function<void(const Progress&)>& work,
                 Cancelling cancelling = Cancelling::Impossible);

/// The same for work that gives a result.
template<typename Work>
auto computeLong(QWidget* window, const QString& title, Work work,
                 Cancelling cancelling = Cancelling::Impossible) {
    std::optional<decltype(work(Progress{}))> result;
    runLongWork(
        window, title, [&](const Progress& progress) { result = work(progress); }, cancelling);
    return std::move(*result);
}

} // namespace esm
