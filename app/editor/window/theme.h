#pragma once

#include "core/render/renderer.h"

#include <QApplication>

namespace esm {

enum class Theme { Dark, Light };

/// Sets palette and style sheet of the whole program. Our own widgets find their colours in the palette:
/// Highlight is the accent as an area, Link the accent as a line or text, LinkVisited amber, PlaceholderText
/// quiet text.
void applyTheme(QApplication& application, Theme theme);

/// Colours behind the organ, top and bottom.
std::pair<Colour, Colour> viewBackground(Theme theme);

} // namespace esm
