#include "widgets/inputs/number_field.h"

#include "widgets/inputs/number_text.h"

#include <QKeyEvent>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace esm {

NumberField::NumberField(NumberFormat format, QWidget* parent)
    : QLineEdit(parent), m_format(std::move(format)) {
    setAlignment(Qt::AlignRight);
    setObjectName(QStringLiteral("numberField"));
    connect(this, &QLineEdit::editingFinished, this, &NumberField::takeText);
    showValue();
}

void NumberField::setValue(std::optional<double> value) {
    if (value == m_value && !isModified()) return;
    m_value = value;
    // What is being typed is not torn away by a value that comes from elsewhere.
    if (!(hasFocus() && isModified())) showValue();
}

void NumberField::setFormat(const NumberFormat& format) {
    m_format = format;
    showValue();
}

QSize NumberField::sizeHint() const {
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("00000.00 ") + m_format.unit) + 18;
    return {width, QLineEdit::sizeHint().height()};
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && isModified()) {
        showValue();
        selectAll();
        return;
    }
    const int direction = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (direction == 0 || !m_value || isReadOnly()) return QLineEdit::keyPressEvent(event);
    const double step = m_format.step > 0 ? m_format.step : std::max(std::abs(*m_value) / 20, 1e-9);
    take(*m_value + direction * step * (event->modifiers() & Qt::ShiftModifier ? 10 : 1));
    selectAll();
}

void NumberField::focusInEvent(QFocusEvent* event) {
    QLineEdit::focusInEvent(event);
    // After the mouse press that gave the focus has placed its cursor.
    QTimer::singleShot(0, this, &QLineEdit::selectAll);
}

void NumberField::takeText() {
    if (!isModified()) return;
    const auto typed = parseNumber(text());
    const double value = typed ? *typed / m_format.shownPerValue : 0;
    if (!typed || value < m_format.minimum || value > m_format.maximum) return showValue();
    take(value);
}

void NumberField::take(double value) {
    value = std::clamp(value, m_format.minimum, m_format.maximum);
    const bool changed = m_value != value;
    m_value = value;
    showValue();
    if (changed) emit valueEdited(value);
}

void NumberField::showValue() {
    QString shown(QChar(0x2013));
    if (m_value) {
        const double number = *m_value * m_format.shownPerValue;
        shown = m_format.decimals < 0 ? numberText(number) : decimalText(number, m_format.decimals);
        if (!m_format.unit.isEmpty()) shown += ' ' + m_format.unit;
    }
    setText(shown);
    setCursorPosition(0);
    setModified(false);
}

} // namespace esm
