#include "widgets/view/marks.h"

#include <cmath>

namespace esm {

namespace {

constexpr double ringRadius = 6.5, markReach = 10; // pixels
constexpr QSizeF numberRoom(22, 16);

void paintRing(QPainter& painter, const PaintedMark& mark, const QColor& colour) {
    const double width = mark.look.isSelected ? 3 : 2;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), width + 2));
    painter.drawEllipse(mark.place, ringRadius, ringRadius);
    painter.setPen(QPen(colour, width));
    painter.drawEllipse(mark.place, ringRadius, ringRadius);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawEllipse(mark.place, 1.4, 1.4);
}

void paintNumber(QPainter& painter, const PaintedMark& mark, const QColor& colour) {
    const QRectF room(mark.place + QPointF(ringRadius, -ringRadius - numberRoom.height()), numberRoom);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(room, 7, 7);
    painter.setPen(QColor(20, 22, 25));
    painter.drawText(room, Qt::AlignCenter, QString::number(mark.look.number));
}

} // namespace

void paintMarks(QPainter& painter, const std::vector<PaintedMark>& marks, const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(11);
    font.setBold(true);
    painter.setFont(font);
    for (const PaintedMark& mark : marks) {
        const QColor colour =
            mark.look.isDoubtful ? palette.color(QPalette::LinkVisited) : QColor(0x3f, 0xb6, 0xa8);
        painter.setOpacity(mark.isHidden ? 0.35 : 1);
        paintRing(painter, mark, colour);
        paintNumber(painter, mark, mark.look.isSelected ? QColor(Qt::white) : colour);
    }
    painter.restore();
}

/// The nearest one within reach: of marks side by side, the one that is meant.
std::optional<int> markAt(const std::vector<PaintedMark>& marks, const QPointF& place) {
    std::optional<int> nearest;
    double least = markReach;
    for (const PaintedMark& mark : marks) {
        const QPointF way = mark.place - place;
        const double distance = std::hypot(way.x(), way.y());
        if (distance > least) continue;
        least = distance;
        nearest = mark.look.number;
    }
    return nearest;
}

} // namespace esm
