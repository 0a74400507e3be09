#include "widgets/view/marks.h"

#include <algorithm>
#include <array>
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

QRectF ringRoom(const PaintedMark& mark) {
    return {mark.place - QPointF(ringRadius, ringRadius), QSizeF(ringRadius, ringRadius) * 2};
}

void paintNumber(QPainter& painter, const PaintedMark& mark, const QRectF& room, const QColor& colour) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(room, 7, 7);
    const bool isDark = qGray(colour.rgb()) < 128;
    painter.setPen(isDark ? QColor(Qt::white) : QColor(20, 22, 25));
    painter.drawText(room, Qt::AlignCenter, QString::number(mark.look.number));
}

} // namespace

// Each at the first of its ring's corners that is free.
std::vector<QRectF> numberRooms(const std::vector<PaintedMark>& marks) {
    const double right = ringRadius, left = -ringRadius - numberRoom.width(), below = ringRadius,
                 above = -ringRadius - numberRoom.height();
    const std::array<QPointF, 4> corners{QPointF(right, above), {left, above}, {right, below}, {left, below}};
    std::vector<QRectF> taken;
    taken.reserve(2 * marks.size());
    for (const PaintedMark& mark : marks)
        taken.push_back(ringRoom(mark));
    for (const PaintedMark& mark : marks) {
        const auto isFree = [&](const QPointF& corner) {
            const QRectF room(mark.place + corner, numberRoom);
            return std::none_of(taken.begin(), taken.end(),
                                [&](const QRectF& other) { return other.intersects(room); });
        };
        const auto free = std::find_if(corners.begin(), corners.end(), isFree);
        taken.push_back({mark.place + (free == corners.end() ? corners.front() : *free), numberRoom});
    }
    return {taken.begin() + static_cast<std::ptrdiff_t>(marks.size()), taken.end()};
}

void paintMarks(QPainter& painter, const std::vector<PaintedMark>& marks, const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(11);
    font.setBold(true);
    painter.setFont(font);
    const std::vector<QRectF> rooms = numberRooms(marks);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const PaintedMark& mark = marks[i];
        const QColor colour =
            mark.look.isDoubtful ? palette.color(QPalette::LinkVisited) : QColor(0x3f, 0xb6, 0xa8);
        painter.setOpacity(mark.isHidden ? 0.35 : 1);
        paintRing(painter, mark, colour);
        paintNumber(painter, mark, rooms[i], mark.look.isSelected ? QColor(Qt::white) : colour);
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
