#pragma once

#include "app/editor/commands/region_edits.h"
#include "widgets/inputs/number_field.h"

#include <QLabel>
#include <QToolButton>

namespace esm {

/// Caption, unit and limits of a tissue parameter.
QString parameterName(Parameter parameter);
QString parameterUnit(Parameter parameter);

/// A tissue parameter without a linguistic variable: its name, a number, and whether it is held.
class ParameterRow : public QWidget {
    Q_OBJECT

public:
    ParameterRow(Parameter parameter, bool canHold, QWidget* parent = nullptr);

    /// A value that is set by hand; none shows that the tissue beneath keeps its own.
    void setValue(std::optional<double> value);
    NumberField* field() const { return m_field; }

signals:
    void valueEdited(double value);
    void released();

private:
    NumberField* m_field;
    QToolButton* m_hold = nullptr;
    QLabel* m_note;
};

} // namespace esm
