#pragma once

#include <QWidget>

namespace esm {

/// What a dialog over the window answers. Where a dialog goes, not every desktop gives the keys back to the
/// window that opened it.
template<typename Dialog> auto ask(QWidget& window, Dialog dialog) {
    auto answer = dialog();
    window.activateWindow();
    return answer;
}

} // namespace esm
