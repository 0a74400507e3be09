#pragma once

#include "core/authoring/regions.h"
#include "widgets/inputs/number_field.h"

#include <QLabel>
#include <QToolButton>

namespace esm {

/// Whose tissue a parameter speaks of: the organ's before any region, or a region's.
enum class Extent { Base, Region };

QString parameterName(Parameter parameter, Extent extent);
/// Unit and limits of a tissue parameter.
NumberFormat parameterFormat(Parameter parameter);

/// A tissue parameter without a linguistic variable: its name, a number, and whether it is held.
class ParameterRow : public QWidget {
    Q_OBJECT

public:
    /// A region's parameter can be held or let go; the base tissue always has a value.
    ParameterRow(Parameter parameter, Extent extent, QWidget* parent = nullptr);

    /// A value that is set by hand; none shows that the tissue beneath keeps its own.
    void setValue(std::optional<double> value);
    /// Of a region: what the tissue beneath has, with its unit; empty where the region reaches none.
    void setBeneath(const QString& beneath);
    NumberField* field() const { return m_field; }

signals:
    void valueEdited(double value);
    /// What follows is another edit.
    void gestureFinished();
    void released();

private:
    NumberField* m_field;
    QToolButton* m_hold = nullptr;
    QLabel* m_beneath = nullptr;
};

} // namespace esm
