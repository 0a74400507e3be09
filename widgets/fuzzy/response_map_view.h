#pragma once

#include "widgets/fuzzy/response_view.h"

#include <QImage>

namespace esm {

/// Colours from dark blue to bright yellow, ever lighter: told apart with any colour vision, and in grey.
QColor mapColour(double share);

/// An output over two inputs, in colours that a legend explains, with the present point on it. Hatched where
/// no rule reaches it.
class ResponseMapView : public ResponseView {
    Q_OBJECT

public:
    explicit ResponseMapView(QWidget* parent = nullptr);

    struct Axes {
        const FuzzyVariable& across;
        const FuzzyVariable& up;
        const FuzzyVariable& output;
        PlotRange values; ///< those that the colours show at least, and their unit
    };
    void setAxes(const Axes& axes);
    void setMap(ResponseMap map);

    PlotFrame frame() const override;
    /// The output at values of the inputs, as drawn; none where no rule reaches it.
    std::optional<double> outputAt(double across, double up) const;

    QSize sizeHint() const override { return {300, 230}; }
    QSize minimumSizeHint() const override { return {200, 170}; }

protected:
    QString textAt(const std::optional<QPointF>& place) const override;
    void draw(QPainter& painter, const PlotFrame& frame) override;
    double stepUp() const override { return 0.01 * m_up.width(); }

private:
    void drawLegend(QPainter& painter, const PlotFrame& frame) const;
    void drawPresent(QPainter& painter, const PlotFrame& frame) const;

    QString m_acrossName, m_upName, m_outputName;
    PlotRange m_up, m_values;
    ResponseMap m_map;
    QImage m_picture; ///< a pixel per cell
};

} // namespace esm
