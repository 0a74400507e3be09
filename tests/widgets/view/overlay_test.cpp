#include "widgets/view/overlay.h"

#include <gtest/gtest.h>
#include <QImage>

using namespace esm;

namespace {

/// How many rows of a picture of this width the hint's pill takes.
int hintHeight(int width, const QString& hint) {
    QImage picture(width, 300, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paintHint(painter, {picture.size(), QPalette(Qt::black)}, hint, false);
    painter.end();
    int rows = 0;
    for (int y = 0; y < picture.height(); ++y)
        rows += picture.pixelColor(width / 2, y).alpha() > 0;
    return rows;
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
