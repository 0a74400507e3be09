#include "app/editor/window/instrument_options.h"

#include "widgets/inputs/quantity_formats.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVariant>

namespace esm {

InstrumentOptions::InstrumentOptions(OrganView& view, ViewController& controller, QWidget* parent)
    : QWidget(parent) {
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

    radius->setValue(controller.instrumentRadius());
    connect(radius, &NumberField::valueEdited, &controller, &ViewController::chooseInstrumentRadius);
    connect(&controller, &ViewController::instrumentRadiusChanged, radius,
            [radius](double metres) { radius->setValue(metres); });
    connect(&view, &OrganView::toolChanged, this,
            [this](ViewTool tool) { setVisible(tool == ViewTool::Instrument); });
    setVisible(view.tool() == ViewTool::Instrument);
}

} // namespace esm
