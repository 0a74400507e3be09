#include "widgets/inputs/refused_numbers.h"

#include "widgets/inputs/number_field.h"

#include <QScrollArea>
#include <QTimer>

namespace esm {

namespace {

void scrollTo(QWidget& field) {
    for (QWidget* around = field.parentWidget(); around; around = around->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(around)) area->ensureWidgetVisible(&field);
}

void goBackTo(NumberField& field) {
    scrollTo(field);
    field.setFocus();
    field.selectAll();
    QTimer::singleShot(0, &field, &NumberField::tellRefusal);
}

} // namespace

bool takesAllNumbers(QWidget& window) {
    for (NumberField* field : window.findChildren<NumberField*>()) {
        if (!field->isEnabled() || !field->isVisibleTo(&window)) continue;
        field->takeTyped();
        if (field->refusal().isEmpty()) continue;
        goBackTo(*field);
        return false;
    }
    return true;
}

} // namespace esm
