#pragma once

#include <QString>
#include <QWidget>

#include <functional>

namespace esm {

/// Every user action that may fail goes through here: what went wrong is shown in plain words, and false
/// returned. A cancelled action says nothing. The action must change nothing before it can no longer fail.
bool attempt(QWidget* window, const QString& title, const std::function<void()>& action);

} // namespace esm
