#pragma once

#include "core/fuzzy/explanation.h"
#include "core/fuzzy/inference.h"
#include "widgets/fuzzy/plot_frame.h"
#include "widgets/inputs/spoken.h"

#include <QWidget>

#include <optional>

namespace esm {

/// What the rules conclude of one output: its terms, what each rule leaves of them, what these make together,
/// and where the centre of gravity of that lies.
class ConclusionView : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit ConclusionView(QWidget* parent = nullptr);

    void setOutput(const FuzzyVariable& output, const QString& unit);
    void setExplanation(OutputExplanation explanation);
    /// The sets of this rule stand out.
    void setChosenRule(std::optional<std::size_t> rule);
    /// What is held in place of the centre of gravity.
    void setHeld(std::optional<double> value);

    /// What is said of a place, or of the centre of gravity.
    QString textAt(std::optional<double> value) const;

    QString spokenValue() const override { return textAt(std::nullopt); }
    QSize sizeHint() const override { return {300, 132}; }
    QSize minimumSizeHint() const override { return {180, 110}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    PlotFrame frame() const;
    void drawTerms(QPainter& painter, const PlotFrame& frame) const;
    void drawSets(QPainter& painter, const PlotFrame& frame) const;
    void drawValue(QPainter& painter, const PlotFrame& frame, double value, const QColor& colour) const;

    FuzzyVariable m_output;
    QString m_unit;
    OutputExplanation m_explanation;
    std::optional<std::size_t> m_chosenRule;
    std::optional<double> m_held, m_pointed;
};

} // namespace esm
