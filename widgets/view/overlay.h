#pragma once

#include <QPainter>
#include <QPalette>
#include <QSize>
#include <QString>

#include <optional>
#include <vector>

namespace esm {

/// What colours mean: values along the ramp, or names.
struct ViewLegend {
    struct Entry {
        QString name;
        QColor colour;
    };
    QString title; ///< "Spring constant"
    QString unit;  ///< "N/m"
    double minimum = 0, maximum = 1;
    std::vector<Entry> entries; ///< in place of values where the unit is empty
};

/// How large the picture is that something is painted over, and in which colours.
struct OverlayStyle {
    QSize view;
    QPalette palette;
};

/// A box at the bottom left with the ramp of colours and its range, or a line for each entry.
void paintLegend(QPainter& painter, const OverlayStyle& style, const ViewLegend& legend);
/// A pill with a text at the bottom, in the middle of what a legend leaves; in lines where one is too long.
/// Its parts lie between " · ", the most needed first: the last are left out where they would hide the organ.
void paintHint(QPainter& painter, const OverlayStyle& style, const QString& hint,
               const ViewLegend* legend = nullptr);
/// A small white mark with a coloured edge that can be taken hold of.
struct PaintedHandle {
    enum class Form { Square, Round, Ring, Diamond };
    QPointF place;
    Form form = Form::Square;
    std::optional<QPointF> root = {}; ///< where the line ends that it hangs on
    bool isLit = false;               ///< filled with the edge's colour, as what the mouse is over
};
void paintHandles(QPainter& painter, const std::vector<PaintedHandle>& handles, const QColor& edge);
/// A pill with a text beside a place in the picture.
void paintLabel(QPainter& painter, const QPointF& beside, const QString& text, const QPalette& palette);
/// The square of the axis cube at the top right.
QRectF cubeSquare(const QSize& view);

} // namespace esm
