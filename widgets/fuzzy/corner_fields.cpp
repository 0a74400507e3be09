#include "widgets/fuzzy/corner_fields.h"

#include "widgets/fuzzy/partition_picture.h"
#include "widgets/fuzzy/term_scale.h"

#include <QGridLayout>
#include <QLabel>

namespace esm {

CornerFields::CornerFields(QWidget* parent) : QWidget(parent), m_fields() {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
    for (const Corner corner : everyCorner) {
        const auto column = static_cast<std::size_t>(corner);
        auto* field = m_fields[column] = new NumberField({}, this);
        auto* caption = new QLabel(cornerUse(corner), this);
        caption->setProperty("quiet", true);
        caption->setBuddy(field);
        caption->setMinimumWidth(0);
        caption->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        field->setAccessibleName(cornerUse(corner));
        field->setMinimumWidth(50);
        field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        grid->addWidget(caption, 0, static_cast<int>(column));
        grid->addWidget(field, 1, static_cast<int>(column));
        grid->setColumnStretch(static_cast<int>(column), 1);
        connect(field, &NumberField::valueEdited, this,
                [this, corner](double value) { emit cornerEdited(corner, value); });
        connect(field, &NumberField::gestureFinished, this, &CornerFields::gestureFinished);
    }
}

void CornerFields::setTerm(const FuzzyVariable& variable, std::size_t term) {
    const Trapezoid& set = variable.terms[term].set;
    for (const Corner corner : everyCorner) {
        NumberFormat format;
        format.unit = QString::fromStdString(variable.unit);
        format.showsUnit = false;
        format.minimum = cornerOf(withCorner(variable, term, corner, format.minimum), corner);
        format.maximum = cornerOf(withCorner(variable, term, corner, format.maximum), corner);
        format.step = cornerStep(variable);
        field(corner)->setFormat(format);
        field(corner)->setValue(cornerOf(set, corner));
        const QString in = format.unit.isEmpty() ? QString() : tr(", in %1").arg(format.unit);
        field(corner)->setToolTip(
            tr("Where “%1” %2%3").arg(readableName(variable.terms[term].name), cornerUse(corner), in));
    }
}

} // namespace esm
