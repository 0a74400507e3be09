#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>

#include <vector>

namespace esm {

/// What an axis shows.
struct PlotRange {
    double minimum = 0, maximum = 1;
    QString unit; ///< may be empty

    double width() const { return maximum - minimum; }
};

/// Round numbers within a range, at most so many.
std::vector<double> scaleMarks(const PlotRange& range, int most);

/// The rectangle of a small plot: where values lie in it, and its scales around it.
class PlotFrame {
public:
    PlotFrame(const QRectF& area, PlotRange across, PlotRange up)
        : m_area(area), m_across(std::move(across)), m_up(std::move(up)) {}

    const QRectF& area() const { return m_area; }
    double x(double value) const;
    double y(double value) const;
    QPointF at(double across, double up) const { return {x(across), y(up)}; }
    /// Values under a place, within the ranges.
    double acrossAt(double x) const;
    double upAt(double y) const;

    /// The frame's background, its lower edge and numbers beneath it, in the painter's font.
    void drawAcross(QPainter& painter, const QPalette& palette) const;
    /// Numbers at the left, one in so many pixels at most.
    void drawUpNumbers(QPainter& painter, const QPalette& palette, double perNumber) const;
    /// The same with fine lines.
    void drawUp(QPainter& painter, const QPalette& palette) const;

private:
    QRectF m_area;
    PlotRange m_across, m_up;
};

} // namespace esm
