#pragma once

#include "core/support/progress.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <optional>

namespace esm {

enum class Cancelling { Offered, Impossible };

/// Does long work on another thread while the window stays alive; after a moment a dialog with progress and,
/// where offered, a cancel button appears. Returns when the work is done and passes on what it throws;
/// Cancelled also when work that reports no progress ended after it was asked to stop.
void runLongWork(QWidget* window, const QString& title, const std::function<void(const Progress&)>& work,
                 Cancelling cancelling = Cancelling::Offered);

/// The same for work that gives a result.
template<typename Work> auto computeLong(QWidget* window, const QString& title, Work work) {
    std::optional<decltype(work(Progress{}))> result;
    runLongWork(window, title, [&](const Progress& progress) { result = work(progress); });
    return std::move(*result);
}

} // namespace esm
