#pragma once

#include "widgets/fuzzy/response_view.h"

namespace esm {

/// An output over one input, with the present point on it and gaps where no rule reaches it.
class ResponseCurveView : public ResponseView {
    Q_OBJECT

public:
    explicit ResponseCurveView(QWidget* parent = nullptr);

    /// @param output the values that the scale shows at least, and their unit
    void setAxes(const FuzzyVariable& input, const FuzzyVariable& outputVariable, PlotRange output);
    void setCurve(ResponseCurve curve);

    PlotFrame frame() const override;
    /// The output at an input's value, as drawn; none in a gap.
    std::optional<double> outputAt(double input) const;

    QSize sizeHint() const override { return {300, 160}; }
    QSize minimumSizeHint() const override { return {180, 130}; }

protected:
    QString textAt(const std::optional<QPointF>& place) const override;
    void draw(QPainter& painter, const PlotFrame& frame) override;

private:
    void drawPresent(QPainter& painter, const PlotFrame& frame) const;

    QString m_inputName, m_outputName;
    PlotRange m_output;
    ResponseCurve m_curve;
};

} // namespace esm
