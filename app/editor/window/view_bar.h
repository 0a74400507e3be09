#pragma once

#include "app/editor/window/actions.h"
#include "core/render/cut_plane.h"
#include "widgets/inputs/value_slider.h"

#include <QComboBox>
#include <QFrame>
#include <QLabel>

namespace esm {

/// A small bar in the view's upper left corner: a button with what is shown, and while the organ is cut open
/// the plane's side and place.
class ViewBar : public QFrame {
    Q_OBJECT

public:
    ViewBar(const Actions& actions, QWidget* view);

    Cut cut() const;

signals:
    void cutChanged();

private:
    void buildCut(const Actions& actions);
    void showCut(bool on);

    QWidget* m_cut;
    QComboBox* m_side;
    ValueSlider* m_share;
    QLabel* m_percent;
};

} // namespace esm
