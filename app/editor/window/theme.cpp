#include "app/editor/window/theme.h"

#include "widgets/inputs/icon.h"

#include <QFile>
#include <QPalette>
#include <QStyleFactory>

namespace esm {

namespace {

QPalette paletteOf(const ThemeColours& colours) {
    const auto colour = [&](const char* name) { return QColor(colours.at(QString::fromLatin1(name))); };
    QPalette palette;
    palette.setColor(QPalette::Window, colour("panel"));
    palette.setColor(QPalette::Base, colour("field"));
    palette.setColor(QPalette::AlternateBase, colour("panel"));
    palette.setColor(QPalette::Button, colour("raised"));
    palette.setColor(QPalette::ToolTipBase, colour("raised"));
    palette.setColor(QPalette::Highlight, colour("accent"));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, colour("bright"));
    palette.setColor(QPalette::LinkVisited, colour("amber"));
    palette.setColor(QPalette::BrightText, colour("red"));
    palette.setColor(QPalette::Mid, colour("border"));
    palette.setColor(QPalette::Dark, colour("line"));
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, colour("text"));
        palette.setColor(QPalette::Disabled, role, colour("disabled"));
    }
    palette.setColor(QPalette::PlaceholderText, colour("quiet"));
    palette.setColor(QPalette::Disabled, QPalette::PlaceholderText, colour("disabled"));
    return palette;
}

QString styleSheetOf(const ThemeColours& colours) {
    QFile file(QStringLiteral(":/style.qss"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QString sheet = QString::fromUtf8(file.readAll());
    for (const auto& [name, colour] : colours)
        sheet.replace('@' + name + '@', colour);
    return sheet;
}

} // namespace

const ThemeColours& themeColours(Theme theme) {
    static const ThemeColours dark{{"name", "dark"},
                                   {"window", "#1b1e22"},
                                   {"panel", "#22262b"},
                                   {"bar", "#262a30"},
                                   {"raised", "#2f353c"},
                                   {"hover", "#3a424a"},
                                   {"pressed", "#262b31"},
                                   {"line", "#15171a"},
                                   {"border", "#3a4149"},
                                   {"field", "#1b1e22"},
                                   {"track", "#3a4149"},
                                   {"text", "#e7e9ec"},
                                   {"quiet", "#98a1ab"},
                                   {"disabled", "#6b747e"},
                                   {"accent", "#237a70"},
                                   {"accentHover", "#258278"},
                                   {"bright", "#3fb6a8"},
                                   {"accentSoft", "#202d2e"},
                                   {"accentBorder", "#2a5450"},
                                   {"wordsText", "#bfeee6"},
                                   {"amber", "#e3a33b"},
                                   {"amberSoft", "#3a3328"},
                                   {"red", "#e76868"},
                                   {"trough", "#15171a"},
                                   {"chosen", "#3a424a"}};
    static const ThemeColours light{
        {"name", "light"},           {"window", "#eef0f2"},    {"panel", "#f8f9fa"},
        {"bar", "#f2f4f5"},          {"raised", "#ffffff"},    {"hover", "#e4e8eb"},
        {"pressed", "#d9dee2"},      {"line", "#d5d9de"},      {"border", "#c3c9cf"},
        {"field", "#ffffff"},        {"track", "#cdd3d8"},     {"text", "#1f2429"},
        {"quiet", "#5b656e"},        {"disabled", "#9aa3ab"},  {"accent", "#217a70"},
        {"accentHover", "#1d6c63"},  {"bright", "#1f7f74"},    {"accentSoft", "#e3f2f0"},
        {"accentBorder", "#a5d3cd"}, {"wordsText", "#14524b"}, {"amber", "#8f5f0c"},
        {"amberSoft", "#f8ecd4"},    {"red", "#b93636"},       {"trough", "#e4e8eb"},
        {"chosen", "#ffffff"}};
    return theme == Theme::Dark ? dark : light;
}

void applyTheme(QApplication& application, Theme theme) {
    loadResources();
    const ThemeColours& colours = themeColours(theme);
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setPalette(paletteOf(colours));
    application.setStyleSheet(styleSheetOf(colours));
}

std::pair<Colour, Colour> viewBackground(Theme theme) {
    if (theme == Theme::Dark) return {{57, 64, 71}, {29, 32, 37}};
    return {{250, 251, 252}, {205, 211, 217}};
}

} // namespace esm
