#pragma once

#include "widgets/inputs/spoken.h"

#include <qwt_plot.h>

#include <map>

namespace esm {

/// What all plots have in common: the theme's colours, a quiet grid, small numbers as many as have room, a
/// caption for each axis, and what is said while there is nothing to show.
class PlainPlot : public QwtPlot, public Spoken {
    Q_OBJECT

public:
    explicit PlainPlot(QWidget* parent = nullptr);

    /// What is said while nothing is drawn.
    void setEmptyText(const QString& text);

    QSize sizeHint() const override { return {300, 230}; }
    QSize minimumSizeHint() const override { return {200, 110}; } ///< whatever its scales say

protected:
    /// Whether there is nothing to show.
    virtual bool isBlank() const = 0;
    /// Gives what is drawn the theme's colours: once the plot is made, and whenever they are others.
    virtual void followTheme();
    /// @param brief where the whole has no room
    void setCaption(int axis, const QString& whole, const QString& brief);

    void drawCanvas(QPainter* painter) override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Caption {
        QString whole, brief;
    };

    void fitScales();

    std::map<int, Caption> m_captions; ///< by their axes
    QString m_emptyText;
};

} // namespace esm
