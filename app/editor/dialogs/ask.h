#pragma once

#include "app/editor/dialogs/key_window.h"

namespace esm {

/// What a dialog over the window answers. The window that had the keys has them again.
template<typename Dialog> auto ask(QWidget& window, Dialog dialog) {
    const KeyWindow before(&window);
    auto answer = dialog();
    before.activateAgain();
    return answer;
}

} // namespace esm
