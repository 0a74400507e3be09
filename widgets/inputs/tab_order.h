#pragma once

#include <QWidget>

namespace esm {

/// Lets Tab follow the order in which layouts hold the controls within a widget, however late they came.
void tabInLayoutOrder(QWidget& whole);

} // namespace esm
