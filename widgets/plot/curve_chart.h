#pragma once

#include "widgets/plot/plain_plot.h"

#include <QPointF>
#include <QVector>

#include <optional>
#include <vector>

class QwtPlotCurve;
class QwtPlotMarker;

namespace esm {

/// A line across a chart at an x, and what it means: "time constant 0.47 s".
struct ChartMark {
    double at;
    QString text;
};

/// What was measured one after the other, by rising x.
struct ChartCurve {
    QString name; ///< "now"
    QVector<QPointF> points;
    std::optional<ChartMark> mark{};
};

/// What an axis says.
struct ChartAxis {
    QString quantity; ///< "depth"
    QString unit;     ///< "mm"
};

/// Curves of one quantity over another, from nothing on. The first is the one that counts; the others are
/// paler. Points that stand apart have dots. Where the mouse rests, or the arrow keys go to, a point of a
/// curve says its numbers.
class CurveChart : public PlainPlot {
    Q_OBJECT

public:
    explicit CurveChart(QWidget* parent = nullptr);

    void setAxes(const ChartAxis& x, const ChartAxis& y);
    void setCurves(std::vector<ChartCurve> curves);
    /// A line upright at an x, such as the moment that is shown elsewhere; none: without.
    void setMoment(std::optional<double> x);

    /// Where a point of a curve lies on the canvas.
    QPoint placeOf(std::size_t curve, int point) const;
    /// "2.000 mm: 0.031 N" of a point that is pointed at, else of each curve's end.
    QString spokenValue() const override;

protected:
    bool isBlank() const override { return m_curves.empty(); }
    void followTheme() override;
    void drawCanvas(QPainter* painter) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    struct Spot {
        std::size_t curve;
        int point;
        bool operator==(const Spot& other) const { return curve == other.curve && point == other.point; }
    };

    void drawScales();
    bool isFalling() const;
    void drawNames(QPainter& painter) const;
    void drawMarks(QPainter& painter) const;
    std::optional<Spot> spotAt(const QPoint& place) const;
    void pointAt(const std::optional<Spot>& spot);
    void stepThrough(int direction);
    QString textOf(const Spot& spot) const;
    QColor colourOf(std::size_t curve) const;

    ChartAxis m_x, m_y;
    std::vector<ChartCurve> m_curves;
    std::vector<QwtPlotCurve*> m_lines; ///< one for each
    QwtPlotCurve* m_pointedMark;
    QwtPlotMarker* m_moment;
    std::optional<Spot> m_pointed;
};

} // namespace esm
