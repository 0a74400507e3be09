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

/// A finger that presses the organ, or a strip of it that is stretched: where, by which test, how large, how
/// far or hard; and what was met in numbers.
class VirtualTestPanel : public QWidget {
    Q_OBJECT

public:
    VirtualTestPanel(Document& document, VirtualTest& test, QWidget* parent = nullptr);

    /// Takes the tool that chooses the place.
    void setPlaceAction(QAction* action);

private:
    QWidget* buildQuestion();
    ValueRows* buildKind();
    ValueRows* buildFingerRows();
    ValueRows* buildStripRows();
    void connectField(NumberField* field, const char* name, void (VirtualTest::*set)(double));
    QWidget* buildButtons();
    void press();
    void refresh();
    void showTest();
    void showNews();
    void showPublished();
    bool isSlack() const;
    QString remark() const;
    QString remarkOnTime() const;
    QString remarkOnFormer() const;
    QString remarkOnFormerStrip() const;
    QString remarkOnPlace() const;
    QString remarkOnPressure() const;

    Document& m_document;
    VirtualTest& m_test;
    QLabel *m_said, *m_place;
    QPushButton *m_choose, *m_press, *m_cancel;
    QComboBox* m_kind;
    ValueRows* m_rows;
    NumberField *m_radius, *m_depth, *m_force, *m_duration;
    NumberField *m_length, *m_width, *m_stretch, *m_turn;
    QStackedWidget* m_sizes; ///< of a finger, or of a strip
    WorkNews* m_news;
    QStackedWidget* m_figures; ///< of each kind of test
    ElidedLabel* m_published;  ///< what is published of the tissue there
};

} // namespace esm
