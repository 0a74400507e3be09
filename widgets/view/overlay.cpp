#include "widgets/view/overlay.h"

#include "core/render/colour_ramp.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

constexpr int margin = 14, padding = 11, legendWidth = 230, legendHeight = 66; // pixels
constexpr int titleHeight = 30, entryHeight = 19, mostEntries = 10;
constexpr int cubeSize = 78, handleSize = 9, hintPadding = 5, narrowestHint = 280;
constexpr double mostOfHeight = 0.2; // of a view, that a hint may hide
constexpr int backgroundAlpha = 225;
constexpr QPointF labelOffset(0, -9); // pixels, from a place to its label's lower edge

QColor background(const QPalette& palette) {
    QColor colour = palette.color(QPalette::Window);
    colour.setAlpha(backgroundAlpha);
    return colour;
}

QFont sized(QFont font, int pixels) {
    font.setPixelSize(pixels);
    return font;
}

QString shortNumber(double value) {
    return QLocale().toString(value, 'g', 3);
}

QLinearGradient rampGradient(const QRectF& bar) {
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int stops = 16;
    for (int i = 0; i <= stops; ++i) {
        const Colour colour = rampColour(double(i) / stops);
        gradient.setColorAt(double(i) / stops, QColor(colour[0], colour[1], colour[2]));
    }
    return gradient;
}

/// The ramp, its two ends and the unit between them.
void paintScale(QPainter& painter, const QRectF& inner, const ViewLegend& legend) {
    const QRectF bar(inner.left(), inner.top() + 24, inner.width(), 8);
    const QRectF range(bar.left(), bar.bottom() + 3, bar.width(), 18);
    painter.drawText(range, Qt::AlignLeft | Qt::AlignVCenter, shortNumber(legend.minimum));
    painter.drawText(range, Qt::AlignHCenter | Qt::AlignVCenter, legend.unit);
    painter.drawText(range, Qt::AlignRight | Qt::AlignVCenter, shortNumber(legend.maximum));
    painter.setPen(Qt::NoPen);
    painter.setBrush(rampGradient(bar));
    painter.drawRoundedRect(bar, 3, 3);
}

/// A long list says how many of it are left out.
int shownEntries(const ViewLegend& legend) {
    return std::clamp(static_cast<int>(legend.entries.size()), 1, mostEntries);
}

void paintEntries(QPainter& painter, const QRectF& inner, const ViewLegend& legend) {
    const int shown = shownEntries(legend), count = static_cast<int>(legend.entries.size());
    const QPen text = painter.pen();
    for (int i = 0; i < shown; ++i) {
        const QRectF line(inner.left(), inner.top() + titleHeight - 7 + i * entryHeight, inner.width(),
                          entryHeight);
        const bool isRest = count == 0 || (i == shown - 1 && count > shown);
        const QString name = count == 0 ? QCoreApplication::translate("esm::Legend", "none yet")
                             : isRest
                                 ? QCoreApplication::translate("esm::Legend", "and %1 more").arg(count - i)
                                 : legend.entries[std::size_t(i)].name;
        painter.setPen(text);
        painter.drawText(line.adjusted(isRest ? 0 : 22, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(name, Qt::ElideRight, int(line.width()) - 22));
        if (isRest) continue;
        painter.setPen(Qt::NoPen);
        painter.setBrush(legend.entries[std::size_t(i)].colour);
        painter.drawRoundedRect(QRectF(line.left(), line.center().y() - 6, 14, 12), 3, 3);
    }
}

QRectF legendBox(const QSize& view, const ViewLegend& legend) {
    const bool isList = legend.unit.isEmpty();
    const double height = isList ? titleHeight + entryHeight * shownEntries(legend) + padding : legendHeight;
    return {double(margin), view.height() - margin - height, double(legendWidth), height};
}

/// Where a hint may stand: beside the legend, or above it where little is left beside.
QRectF hintRoom(const QSize& view, const ViewLegend* legend) {
    QRectF room(margin, 0, view.width() - 2 * margin, view.height() - margin);
    if (!legend) return room;
    const QRectF box = legendBox(view, *legend);
    if (room.right() - box.right() - margin >= narrowestHint)
        room.setLeft(box.right() + margin);
    else
        room.setBottom(box.top() - margin);
    return room;
}

QRectF textBox(const QPainter& painter, const QString& text, double width) {
    return painter.fontMetrics().boundingRect(QRect(0, 0, static_cast<int>(width), 1000),
                                              Qt::AlignCenter | Qt::TextWordWrap, text);
}

/// As many parts of a hint as have room, and of the first as many words, one at least.
QString fittingHint(const QPainter& painter, const QString& hint, const QSizeF& room) {
    const QString between = QStringLiteral(" · ");
    const auto fits = [&](const QString& text) {
        return textBox(painter, text, room.width()).height() <= room.height();
    };
    QStringList parts = hint.split(between);
    while (parts.size() > 1 && !fits(parts.join(between)))
        parts.removeLast();
    if (parts.size() > 1 || fits(parts.front())) return parts.join(between);
    QStringList words = parts.front().split(QLatin1Char(' '));
    const auto shortened = [&] { return words.join(QLatin1Char(' ')) + QStringLiteral("…"); };
    while (words.size() > 1 && !fits(shortened()))
        words.removeLast();
    return shortened();
}

QPolygonF diamondIn(const QRectF& box) {
    const QPointF middle = box.center();
    return QPolygonF(QVector<QPointF>{{middle.x(), box.top()},
                                      {box.right(), middle.y()},
                                      {middle.x(), box.bottom()},
                                      {box.left(), middle.y()}});
}

void paintForm(QPainter& painter, const PaintedHandle& handle, const QColor& edge) {
    const QRectF box(handle.place - QPointF(handleSize, handleSize) / 2, QSizeF(handleSize, handleSize));
    switch (handle.form) {
    case PaintedHandle::Form::Square:
        return painter.drawRect(box);
    case PaintedHandle::Form::Round:
        return painter.drawEllipse(box.adjusted(-0.5, -0.5, 0.5, 0.5));
    case PaintedHandle::Form::Ring:
        painter.drawEllipse(box.adjusted(-2, -2, 2, 2));
        painter.setBrush(handle.isLit ? QColor(Qt::white) : edge);
        return painter.drawEllipse(box.adjusted(2.5, 2.5, -2.5, -2.5));
    case PaintedHandle::Form::Diamond:
        return painter.drawPolygon(diamondIn(box.adjusted(-1.5, -1.5, 1.5, 1.5)));
    }
}

} // namespace

void paintLegend(QPainter& painter, const OverlayStyle& style, const ViewLegend& legend) {
    const QRectF box = legendBox(style.view, legend);
    const QRectF inner = box.adjusted(padding, 7, -padding, -padding);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(style.palette.color(QPalette::Mid), 1));
    painter.setBrush(background(style.palette));
    painter.drawRoundedRect(box, 6, 6);
    painter.setPen(style.palette.color(QPalette::WindowText));
    painter.setFont(sized(painter.font(), 13));
    painter.drawText(QRectF(inner.topLeft(), QSizeF(inner.width(), 20)), Qt::AlignLeft | Qt::AlignVCenter,
                     legend.title);
    painter.setFont(sized(painter.font(), 12));
    if (legend.unit.isEmpty())
        paintEntries(painter, inner, legend);
    else
        paintScale(painter, inner, legend);
    painter.restore();
}

void paintHint(QPainter& painter, const OverlayStyle& style, const QString& hint, const ViewLegend* legend) {
    if (hint.isEmpty()) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(sized(painter.font(), 12));
    const QRectF room = hintRoom(style.view, legend);
    const double line = textBox(painter, hint, 1e5).height();
    const QSizeF most(room.width() - 2 * padding,
                      std::max(line, mostOfHeight * style.view.height() - 2 * hintPadding));
    const QString shown = fittingHint(painter, hint, most);
    const QRectF text = textBox(painter, shown, most.width());
    const double width = text.width() + 2 * padding, height = text.height() + 2 * hintPadding;
    const double centred = (style.view.width() - width) / 2;
    const QRectF pill(std::max(room.left(), centred), room.bottom() - height, width, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(background(style.palette));
    painter.drawRoundedRect(pill, 13, 13);
    painter.setPen(style.palette.color(QPalette::WindowText));
    painter.drawText(pill.adjusted(padding - 1, 0, 1 - padding, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     shown);
    painter.restore();
}

void paintHandles(QPainter& painter, const std::vector<PaintedHandle>& handles, const QColor& edge) {
    painter.save();
    painter.setPen(QPen(edge, 1.4));
    for (const PaintedHandle& handle : handles)
        if (handle.root) painter.drawLine(*handle.root, handle.place);
    for (const PaintedHandle& handle : handles) {
        painter.setBrush(handle.isLit ? edge : QColor(Qt::white));
        paintForm(painter, handle, edge);
    }
    painter.restore();
}

void paintLabel(QPainter& painter, const QPointF& beside, const QString& text, const QPalette& palette) {
    QRectF room = painter.fontMetrics().boundingRect(text);
    room.adjust(-8, -3, 8, 3);
    room.moveCenter(beside + labelOffset - QPointF(0, room.height() / 2));
    // Wholly in the picture, whose top left corner is the origin.
    const QSizeF free = QSizeF(painter.window().size()) - room.size();
    room.moveTopLeft({std::clamp(room.left(), 0.0, std::max(0.0, free.width())),
                      std::clamp(room.top(), 0.0, std::max(0.0, free.height()))});
    QColor background = palette.color(QPalette::Window);
    background.setAlpha(backgroundAlpha);
    painter.setPen(Qt::NoPen);
    painter.setBrush(background);
    painter.drawRoundedRect(room, room.height() / 2, room.height() / 2);
    painter.setPen(palette.color(QPalette::WindowText));
    painter.drawText(room, Qt::AlignCenter, text);
}

QRectF cubeSquare(const QSize& view) {
    return {double(view.width() - margin - cubeSize), double(margin), cubeSize, cubeSize};
}

} // namespace esm
