#pragma once

#include "app/editor/panels/measure/press_figures.h"
#include "app/editor/panels/measure/work_news.h"
#include "app/editor/workers/virtual_test.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QAction>
#include <QComboBox>
#include <QPushButton>
#include <QStackedWidget>

namespace esm {

/// A finger that presses the organ: where, by which test, how large, how deep or hard; and what it met in
/// numbers.
class VirtualTestPanel : public QWidget {
    Q_OBJECT

public:
    VirtualTestPanel(Document& document, VirtualTest& test, QWidget* parent = nullptr);

    /// Takes the tool that chooses the place.
    void setPlaceAction(QAction* action);

private:
    QWidget* buildFinger();
    ValueRows* buildTest();
    QWidget* buildButtons();
    void press();
    void refresh();
    void showTest();
    void showNews();
    void showPublished();
    QString remark() const;
    QString remarkOnTime() const;
    QString remarkOnFormer() const;
    QString remarkOnPlace() const;

    Document& m_document;
    VirtualTest& m_test;
    QLabel *m_said, *m_place;
    QPushButton *m_choose, *m_press, *m_cancel;
    QComboBox* m_kind;
    ValueRows* m_rows;
    NumberField *m_radius, *m_depth, *m_force, *m_duration;
    WorkNews* m_news;
    QStackedWidget* m_figures; ///< of each kind of test
    ElidedLabel* m_published;  ///< what is published of the tissue there
};

} // namespace esm
