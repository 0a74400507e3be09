#pragma once

#include <QWidget>

#include <functional>

namespace esm {

/// While the widget is seen, [ and ] make a brush smaller and larger: they ask for so many times its size.
void sizeByBrackets(QWidget& seen, const std::function<void(double factor)>& resize);

} // namespace esm
