#pragma once

#include "widgets/inputs/number_field.h"

#include <Eigen/Core>

#include <QWidget>

#include <array>
#include <optional>

namespace esm {

/// Three numbers side by side, in one unit that the row's caption names.
class VectorField : public QWidget {
    Q_OBJECT

public:
    explicit VectorField(const NumberFormat& format, QWidget* parent = nullptr);

    /// Its three fields are called by it and their axis, with the unit that a caption names: "Centre x, mm".
    void setCaption(const QString& caption);
    void setToolTip(const QString& toolTip);
    /// Shows a value without announcing it; none shows dashes.
    void setValue(const std::optional<Eigen::Vector3d>& value);
    NumberField* field(int axis) const { return m_fields[static_cast<std::size_t>(axis)]; }

signals:
    void valueEdited(const Eigen::Vector3d& value);
    /// As a number field's: what follows is another edit.
    void gestureFinished();

private:
    std::array<NumberField*, 3> m_fields;
};

} // namespace esm
