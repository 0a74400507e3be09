#pragma once

#include "app/editor/edits/parameter_name.h"
#include "widgets/inputs/number_field.h"

#include <QLabel>
#include <QToolButton>

namespace esm {

/// Unit and limits of a tissue parameter.
NumberFormat parameterFormat(Parameter parameter);

/// A tissue parameter without a linguistic variable: its name, a number, and whether it is held.
class ParameterRow : public QWidget {
    Q_OBJECT

public:
    /// A region's parameter can be held or let go; the base tissue always has a value.
    ParameterRow(Parameter parameter, Extent extent, QWidget* parent = nullptr);

    /// None shows that the tissue beneath keeps its own. A region's may be set by hand, and be let go again.
    enum class Manner { Usual, Held };
    void setValue(std::optional<double> value, Manner manner = Manner::Usual);
    /// Beneath a region's row: how the value came about, or what is kept.
    void setRemark(const QString& remark);
    NumberField* field() const { return m_field; }

signals:
    void valueEdited(double value);
    /// What follows is another edit.
    void gestureFinished();
    void released();

private:
    NumberField* m_field;
    QToolButton* m_hold = nullptr;
    QLabel* m_remark = nullptr;
};

} // namespace esm
