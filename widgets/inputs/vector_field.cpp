#include "widgets/inputs/vector_field.h"

#include <QHBoxLayout>

namespace esm {

VectorField::VectorField(const NumberFormat& format, QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (auto& field : m_fields) {
        field = new NumberField(format, this);
        field->setMinimumWidth(40);
        field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        row->addWidget(field, 1);
        connect(field, &NumberField::valueEdited, this, [this] {
            Eigen::Vector3d value;
            for (int axis = 0; axis < 3; ++axis)
                value[axis] = this->field(axis)->value().value_or(0);
            emit valueEdited(value);
        });
        connect(field, &NumberField::gestureFinished, this, &VectorField::gestureFinished);
    }
    setFocusProxy(m_fields[0]);
}

void VectorField::setCaption(const QString& caption) {
    for (int axis = 0; axis < 3; ++axis)
        field(axis)->setAccessibleName(
            QStringLiteral("%1 %2, %3").arg(caption, QChar('x' + axis), field(axis)->format().unit));
}

void VectorField::setToolTip(const QString& toolTip) {
    for (NumberField* field : m_fields)
        field->setToolTip(toolTip);
}

void VectorField::setValue(const std::optional<Eigen::Vector3d>& value) {
    for (int axis = 0; axis < 3; ++axis)
        field(axis)->setValue(value ? std::optional((*value)[axis]) : std::nullopt);
}

} // namespace esm
