#include "widgets/inputs/tab_order.h"

#include <QLayout>

#include <vector>

namespace esm {

namespace {

void collectControls(const QLayout* layout, std::vector<QWidget*>& controls) {
    for (int i = 0; layout && i < layout->count(); ++i) {
        QLayoutItem* item = layout->itemAt(i);
        collectControls(item->layout(), controls);
        QWidget* widget = item->widget();
        if (!widget) continue;
        if (widget->focusPolicy() & Qt::TabFocus) controls.push_back(widget);
        collectControls(widget->layout(), controls);
    }
}

} // namespace

void tabInLayoutOrder(QWidget& whole) {
    std::vector<QWidget*> controls;
    collectControls(whole.layout(), controls);
    for (std::size_t i = 1; i < controls.size(); ++i)
        QWidget::setTabOrder(controls[i - 1], controls[i]);
}

} // namespace esm
