#pragma once

#include "widgets/inputs/elided_label.h"

#include <QBoxLayout>
#include <QPushButton>

namespace esm {

/// Above curves of what was measured last and of what it is compared with: a title, and what can be done with
/// them. Where that is too narrow for one row, what saves them stands below.
class ComparisonHeader : public QWidget {
    Q_OBJECT

public:
    /// What there is to be done with.
    struct State {
        bool isMeasured; ///< something was
        bool canBeKept;  ///< it is not itself what the next is compared with
        bool hasFormer;  ///< something to compare with
    };
    /// What the buttons do, where they can be used.
    struct Texts {
        QString keep, clear, table;
        QString isKept, hasNoFormer, hasNone; ///< why they cannot be used
    };

    /// @param subject of what is measured, by which buttons are found: "Press" for "keepPress", "clearPress",
    /// "savePressTable" and "savePressChart"
    explicit ComparisonHeader(const QString& subject, QWidget* parent = nullptr);

    void setTitle(const QString& title) { m_title->setText(title); }
    void setState(const State& state, const Texts& texts);
    /// One more button that saves something, at the end.
    void addButton(QPushButton* button) { add(button, m_saving); }

    QSize minimumSizeHint() const override { return {0, QWidget::minimumSizeHint().height()}; }

signals:
    void keepAsked();
    void clearAsked();
    void tableAsked();
    void chartAsked();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void add(QPushButton* button, QBoxLayout* row);

    QBoxLayout *m_all, *m_comparing, *m_saving;
    ElidedLabel* m_title;
    QPushButton *m_keep, *m_clear, *m_table, *m_chart;
};

} // namespace esm
