#pragma once

#include "core/fuzzy/output_response.h"
#include "widgets/fuzzy/plot_frame.h"
#include "widgets/inputs/gesture.h"
#include "widgets/inputs/spoken.h"

#include <QWidget>

#include <optional>

namespace esm {

/// What curves and maps of an output have in common: a place in them stands for values of inputs, which a
/// click, a drag or the arrow keys set; the mouse over them says what the output would be.
class ResponseView : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit ResponseView(QWidget* parent);

    /// The inputs as they are set, by their axes: what the arrow keys step from. What they come to is told by
    /// setPresent(), it may be later.
    void setInputs(std::optional<double> across, std::optional<double> up);
    /// The inputs that the output is known at, and where what is drawn stands.
    void setPresent(std::optional<double> across, std::optional<double> up, std::optional<double> output);
    /// What is drawn is being computed anew: it is shown faintly until then.
    void setStale(bool stale);
    /// Where values lie in the widget.
    virtual PlotFrame frame() const = 0;
    /// What is said of the place that the mouse points at, or of the present one.
    QString said() const { return textAt(spokenPlace()); }
    /// What is said of the present place.
    QString spokenValue() const override { return textAt(std::nullopt); }

signals:
    /// The inputs are to be these; one without a value stays as it is.
    void inputsSet(std::optional<double> across, std::optional<double> up);
    /// The drag or the run of keys is over: what follows is another edit.
    void gestureFinished();

protected:
    /// What is said of a place; of the present one without.
    virtual QString textAt(const std::optional<QPointF>& place) const = 0;
    virtual void draw(QPainter& painter, const PlotFrame& frame) = 0;
    /// How far the arrow keys go up; 0 where that has no meaning.
    virtual double stepUp() const { return 0; }

    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void leaveEvent(QEvent* event) override;

    PlotRange m_across; ///< the input's
    std::optional<double> m_presentAcross, m_presentUp, m_presentOutput;
    std::optional<QPointF> m_pointed; ///< where the mouse is
    bool m_isDragged = false;

private:
    void setFrom(const QPointF& place);
    std::optional<QPointF> spokenPlace() const;

    std::optional<double> m_setAcross, m_setUp;
    bool m_isStale = false;
    KeyRun m_keys{[this] { emit gestureFinished(); }};
};

} // namespace esm
