#pragma once

#include "core/render/renderer.h"

#include <QApplication>
#include <QString>

#include <map>

namespace esm {

enum class Theme { Dark, Light };

/// A theme's colours by the names that the style sheet knows them by.
using ThemeColours = std::map<QString, QString>;
const ThemeColours& themeColours(Theme theme);

/// Sets palette and style sheet of the whole program. Our own widgets find their colours in the palette:
/// Highlight is the accent as an area, Link the accent as a line or text, LinkVisited amber, PlaceholderText
/// quiet text.
void applyTheme(QApplication& application, Theme theme);

/// Colours behind the organ, top and bottom.
std::pair<Colour, Colour> viewBackground(Theme theme);

} // namespace esm
