#pragma once

#include <QFont>

namespace esm {

/// For the scales of plots and the terms beneath a slider.
inline QFont smallFont(QFont font) {
    font.setPointSizeF(font.pointSizeF() * 0.84);
    return font;
}

} // namespace esm
