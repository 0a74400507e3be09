#pragma once

#include "app/editor/panels/measure/press_figures.h"
#include "app/editor/workers/virtual_test.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QAction>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>

namespace esm {

/// A finger that presses the organ: where, how large, how deep; and what it met in numbers.
class VirtualTestPanel : public QWidget {
    Q_OBJECT

public:
    VirtualTestPanel(Document& document, VirtualTest& test, QWidget* parent = nullptr);

    /// Takes the tool that chooses the place.
    void setPlaceAction(QAction* action);

private:
    QWidget* buildFinger();
    QWidget* buildButtons();
    QWidget* buildNews();
    void press();
    void refresh();
    void showNews();
    void showPublished();
    QString remark() const;

    Document& m_document;
    VirtualTest& m_test;
    QLabel* m_place;
    QPushButton *m_choose, *m_press, *m_cancel;
    NumberField *m_radius, *m_depth;
    QStackedWidget* m_news; ///< what is said, or how far the work is
    QLabel* m_message;
    QProgressBar* m_progress;
    QTimer m_patience; ///< until work is long enough for a bar
    PressFigures* m_figures;
    ElidedLabel* m_published; ///< what is published of the tissue there
};

} // namespace esm
