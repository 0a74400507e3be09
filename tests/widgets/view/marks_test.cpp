#include "widgets/view/marks.h"

#include <gtest/gtest.h>
#include <QImage>

using namespace esm;

TEST(Marks, NumbersOfNeighboursLieOnNoOtherRingOrNumber) {
    const std::vector<PaintedMark> marks{{{100, 100}, {1}}, {{90, 125}, {2}}, {{118, 88}, {3}}};
    const std::vector<QRectF> rooms = numberRooms(marks);
    ASSERT_EQ(rooms.size(), marks.size());
    for (std::size_t i = 0; i < rooms.size(); ++i)
        for (std::size_t j = 0; j < marks.size(); ++j) {
            EXPECT_FALSE(rooms[i].contains(marks[j].place)) << i << " on ring " << j;
            if (i != j) {
                EXPECT_FALSE(rooms[i].intersects(rooms[j])) << i << " on " << j;
            }
        }
}

TEST(Marks, ANumberCanBeReadOnDoubtfulMarksOfEveryTheme) {
    for (const QColor& amber : {QColor("#e3a33b"), QColor("#8f5f0c")}) {
        QPalette palette;
        palette.setColor(QPalette::LinkVisited, amber);
        QImage picture(80, 60, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        const std::vector<PaintedMark> marks{{{30, 40}, {8, true}}};
        paintMarks(painter, marks, palette);
        painter.end();
        const QRect room = numberRooms(marks).front().toRect();
        int most = 0;
        for (int x = room.left(); x <= room.right(); ++x)
            for (int y = room.top(); y <= room.bottom(); ++y)
                if (picture.pixelColor(x, y).alpha() == 255)
                    most = std::max(most, std::abs(qGray(picture.pixel(x, y)) - qGray(amber.rgb())));
        EXPECT_GT(most, 100) << amber.name().toStdString();
    }
}
