#pragma once

#include "widgets/plot/plain_plot.h"

#include <optional>
#include <vector>

class QwtPlotCurve;
class QwtPlotMarker;

namespace esm {

/// One way to compute a motion.
struct AccuracyPoint {
    double speed = 0; ///< times real time
    double error = 0; ///< relative to the motion
    QString text;     ///< what is said where the mouse rests
};

/// Error over speed of many ways to compute the same motion, both logarithmic: the better, the further to the
/// right and the lower. A click marks a point, as the arrow keys do from one speed to the next; a double
/// click or Enter chooses it.
class AccuracyChart : public PlainPlot {
    Q_OBJECT

public:
    explicit AccuracyChart(QWidget* parent = nullptr);

    /// What has no place on logarithmic scales is not drawn.
    /// @param front the points that none beats in both, by their place in `points`
    /// Nothing is marked then, and none is in use.
    void setPoints(std::vector<AccuracyPoint> points, const std::vector<std::size_t>& front);
    /// The point that is marked as the one in use.
    void setChosen(std::optional<std::size_t> point);
    void mark(std::optional<std::size_t> point);
    /// The largest error that is wanted, a line; that of real time always stands.
    void setMostError(double error);

    /// The point nearest to a place on the canvas; none where all are further than a finger's breadth.
    std::optional<std::size_t> pointAt(const QPoint& place) const;
    /// Where a point lies on the canvas.
    QPoint placeOf(std::size_t point) const;

    /// The point that is pointed at, else the marked one, else the one in use, else how many there are.
    QString spokenValue() const override;

signals:
    void marked(std::size_t point);
    void chosen(std::size_t point);

protected:
    bool isBlank() const override { return m_bySpeed.empty(); }
    void followTheme() override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    bool isDrawn(std::size_t point) const;
    void drawScales();
    void followMouse(QEvent* event);
    void point(std::optional<std::size_t> point);
    void explain(std::size_t point);
    void stepThrough(int direction);
    void ring(QwtPlotCurve* mark, std::optional<std::size_t> point);

    std::vector<AccuracyPoint> m_points;
    std::vector<std::size_t> m_bySpeed; ///< those that are drawn
    std::optional<std::size_t> m_chosen, m_marked, m_pointed;
    QwtPlotCurve *m_others, *m_front, *m_chosenMark, *m_markedMark, *m_pointedMark;
    QwtPlotMarker *m_realTime, *m_mostError;
};

} // namespace esm
