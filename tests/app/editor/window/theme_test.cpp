#include "app/editor/window/theme.h"
#include "tests/support/eventually.h"
#include "widgets/plot/accuracy_chart.h"

#include <gtest/gtest.h>
#include <QColor>
#include <QPalette>
#include <QTest>

#include <cmath>

using namespace esm;

namespace {

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

/// The contrast ratio of the Web Content Accessibility Guidelines 2, 1 to 21.
double contrast(const QColor& a, const QColor& b) {
    const double p = luminance(a) + 0.05, q = luminance(b) + 0.05;
    return std::max(p, q) / std::min(p, q);
}

struct Pair {
    const char *text, *ground;
};

} // namespace

TEST(Theme, TextStandsOutFromItsGround) {
    const std::vector<Pair> pairs{{"text", "window"},  {"text", "panel"},           {"text", "raised"},
                                  {"text", "hover"},   {"text", "field"},           {"quiet", "window"},
                                  {"quiet", "panel"},  {"quiet", "trough"},         {"text", "chosen"},
                                  {"white", "accent"}, {"white", "accentHover"},    {"bright", "panel"},
                                  {"amber", "panel"},  {"amber", "amberSoft"},      {"red", "panel"},
                                  {"red", "field"},    {"wordsText", "accentSoft"}, {"quiet", "field"},
                                  {"bright", "field"}, {"amber", "field"},          {"text", "accentBorder"}};
    for (const Theme theme : {Theme::Dark, Theme::Light})
        for (const Pair& pair : pairs) {
            const auto colour = [&](const char* name) {
                return QString(name) == "white" ? QColor(Qt::white) : QColor(themeColours(theme).at(name));
            };
            EXPECT_GE(contrast(colour(pair.text), colour(pair.ground)), 4.5)
                << themeColours(theme).at("name").toStdString() << ": " << pair.text << " on " << pair.ground;
        }
}

TEST(Theme, ThePaletteIsTheStyleSheets) {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(*qApp, theme);
        const ThemeColours& colours = themeColours(theme);
        EXPECT_EQ(qApp->palette().color(QPalette::Window), QColor(colours.at("panel")));
        EXPECT_EQ(qApp->palette().color(QPalette::Highlight), QColor(colours.at("accent")));
        EXPECT_FALSE(qApp->styleSheet().contains('@')) << "a colour without a name";
    }
    applyTheme(*qApp, Theme::Dark);
}

TEST(Theme, ReachesAChartThatIsShown) {
    AccuracyChart chart;
    chart.resize(320, 240);
    chart.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&chart, patience));
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(*qApp, theme);
        const QColor field(themeColours(theme).at("field"));
        EXPECT_TRUE(QTest::qWaitFor(
            [&] { return chart.canvas()->grab().toImage().pixelColor(3, 3) == field; }, patience));
    }
}
