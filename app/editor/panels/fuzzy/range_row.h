#pragma once

#include "core/fuzzy/partition_edits.h"
#include "widgets/inputs/number_field.h"

#include <QCheckBox>

namespace esm {

/// The range and the unit of a variable.
class RangeRow : public QWidget {
    Q_OBJECT

public:
    explicit RangeRow(QWidget* parent = nullptr);

    /// Shows a variable without announcing it.
    void setVariable(const FuzzyVariable& variable);

signals:
    void rangeEdited(double minimum, double maximum, esm::TermsInRange terms);
    void unitEdited(const std::string& unit);
    /// What follows is another edit.
    void gestureFinished();

private:
    void announceRange(double minimum, double maximum);

    NumberField *m_minimum, *m_maximum;
    QLineEdit* m_unit;
    QCheckBox* m_stretches;
};

} // namespace esm
