#pragma once

#include <QString>
#include <QWidget>

#include <functional>
#include <string>
#include <vector>

namespace esm {

/// Every user action that may fail goes through here: what went wrong is shown in plain words, and false
/// returned. A cancelled action says nothing. The action must change nothing before it can no longer fail.
bool attempt(QWidget* window, const QString& title, const std::function<void()>& action);

/// What the user should know of an action that succeeded; nothing is shown where there is nothing to tell.
void tell(QWidget* window, const QString& title, const std::vector<std::string>& remarks);

} // namespace esm
