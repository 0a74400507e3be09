#include "app/editor/tools/instrument_options.h"

#include "widgets/inputs/number_field.h"
#include "widgets/inputs/quantity_formats.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVariant>

namespace esm {

InstrumentOptions::InstrumentOptions(InstrumentTool& tool, QWidget* parent) : QWidget(parent) {
    auto* caption = new QLabel(tr("Instrument radius"), this);
    caption->setProperty("quiet", true);
    auto* radius = new NumberField(lengthFormat(smallestLength), this);
    radius->setFixedWidth(92);
    radius->setAccessibleName(caption->text());
    caption->setBuddy(radius);
    for (QWidget* widget : std::initializer_list<QWidget*>{caption, radius})
        widget->setToolTip(tr("Radius of the round instrument that pushes the tissue"));
    auto* row = new QHBoxLayout(this);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    row->setContentsMargins(10, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(caption);
    row->addWidget(radius);

    radius->setValue(tool.radius());
    connect(radius, &NumberField::valueEdited, &tool, &InstrumentTool::chooseRadius);
    connect(&tool, &InstrumentTool::radiusChanged, radius,
            [radius](double metres) { radius->setValue(metres); });
}

} // namespace esm
