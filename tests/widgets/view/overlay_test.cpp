#include "widgets/view/overlay.h"

#include <gtest/gtest.h>
#include <QImage>

using namespace esm;

namespace {

/// What the hint's pill takes of a picture of this size.
QRect hintRect(int width, const QString& hint, int height) {
    QImage picture(width, height, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paintHint(painter, {picture.size(), QPalette(Qt::black)}, hint);
    painter.end();
    QRect taken;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (picture.pixelColor(x, y).alpha() > 0) taken |= QRect(x, y, 1, 1);
    return taken;
}

int hintHeight(int width, const QString& hint, int height = 300) {
    return hintRect(width, hint, height).height();
}

int hintWidth(int width, const QString& hint, int height) {
    return hintRect(width, hint, height).width();
}

} // namespace

TEST(Overlay, ALongHintIsWrapped) {
    const QString hint = "Move to touch the surface · Ctrl and wheel push in and out · Esc takes it away";
    const int line = hintHeight(900, hint);
    EXPECT_GT(line, 15);
    EXPECT_EQ(hintHeight(900, "short"), line);
    EXPECT_GT(hintHeight(400, hint), line + 10);
    EXPECT_GT(hintHeight(220, hint), hintHeight(400, hint));
}

TEST(Overlay, ALegendOfRegionsShowsTheirColoursAndSaysHowManyAreLeftOut) {
    const auto painted = [](int regions) {
        ViewLegend legend{"Region", "", 0, 0, {}};
        for (int i = 0; i < regions; ++i)
            legend.entries.push_back({QString("region %1").arg(i), QColor(200, 10 * i, 0)});
        QImage picture(600, 400, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paintLegend(painter, {picture.size(), QPalette(Qt::black)}, legend);
        return picture;
    };
    const auto colours = [](const QImage& picture) {
        int swatches = 0;
        QRgb last = 0;
        for (int y = 0; y < picture.height(); ++y) {
            const QRgb pixel = picture.pixel(14 + 11 + 7, y);
            swatches += qRed(pixel) == 200 && pixel != last ? 1 : 0;
            last = pixel;
        }
        return swatches;
    };
    EXPECT_EQ(colours(painted(3)), 3);
    EXPECT_EQ(colours(painted(10)), 10);
    EXPECT_EQ(colours(painted(25)), 9) << "and a line for the rest";
    EXPECT_EQ(colours(painted(0)), 0);
}

TEST(Overlay, AHintOfManyPartsKeepsTheFirstInALowView) {
    const QString first = "Click a point in the photo, then the same point on the organ";
    const QString all = first + " · drag a mark to move it · drag elsewhere to turn the view";
    EXPECT_EQ(hintHeight(400, all, 150), hintHeight(400, first, 150));
    EXPECT_GT(hintHeight(400, all, 400), hintHeight(400, first, 400));
    EXPECT_EQ(hintWidth(900, all, 80), hintWidth(900, all, 400)) << "one line always has room";
    EXPECT_EQ(hintHeight(220, all, 120), hintHeight(900, "short", 120)) << "and more is not to be had there";
    EXPECT_GT(hintHeight(220, all, 220), hintHeight(900, "short", 220)) << "what room there is is used";
}

TEST(Overlay, AHintStandsAboveTheLegendWhereLittleIsLeftBesideIt) {
    const ViewLegend legend{"Spring constant", "N/m", 0, 1, {}};
    const auto lowestRow = [&](int width) {
        QImage picture(width, 300, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paintHint(painter, {picture.size(), QPalette(Qt::black)}, "Drag to turn the view", &legend);
        painter.end();
        for (int y = picture.height() - 1; y >= 0; --y)
            for (int x = 0; x < width; ++x)
                if (picture.pixelColor(x, y).alpha() > 0) return y;
        return -1;
    };
    EXPECT_GT(lowestRow(900), 270);
    EXPECT_LT(lowestRow(400), 230);
}
