#include "widgets/inputs/number_field.h"

#include "widgets/inputs/number_text.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QToolTip>
#include <QVariant>

#include <algorithm>
#include <cmath>

namespace esm {

NumberField::NumberField(NumberFormat format, QWidget* parent)
    : QLineEdit(parent), m_format(std::move(format)) {
    setAlignment(Qt::AlignRight);
    setObjectName(QStringLiteral("numberField"));
    connect(this, &QLineEdit::editingFinished, this, &NumberField::takeTyped);
    connect(this, &QLineEdit::textEdited, this, [this] { setRefusal({}); });
    showValue();
}

void NumberField::setValue(std::optional<double> value) {
    if (value == m_value && !isModified()) return;
    m_value = value;
    // What is being typed is not torn away by a value that comes from elsewhere.
    if (!(hasFocus() && isModified())) showValue();
}

void NumberField::setFormat(NumberFormat format) {
    const bool looksDifferent = format.unit != m_format.unit || format.showsUnit != m_format.showsUnit ||
                                format.shownPerValue != m_format.shownPerValue ||
                                format.decimals != m_format.decimals;
    m_format = std::move(format);
    if (looksDifferent && !isModified()) showValue();
}

void NumberField::setEmptyText(const QString& text) {
    m_emptyText = text;
    if (!isModified()) showValue();
}

QSize NumberField::sizeHint() const {
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("00000.00 ") + m_format.unit) + 18;
    return {width, QLineEdit::sizeHint().height()};
}

int NumberField::widthFor(const QString& unit) const {
    const QString minus(QChar(0x2212)), sign = m_format.minimum < 0 ? minus : QString();
    const QString longest = sign + QStringLiteral("0.000e") + minus + QStringLiteral("00");
    return fontMetrics().horizontalAdvance(unit.isEmpty() ? longest : longest + ' ' + unit) + textMargin();
}

/// What the frame and the space within it take of the width: QLineEdit's own hint has room for seventeen x.
int NumberField::textMargin() const {
    return QLineEdit::sizeHint().width() - 17 * fontMetrics().horizontalAdvance('x') + 2;
}

bool NumberField::isCut() const {
    return fontMetrics().horizontalAdvance(text()) + textMargin() > width() + 2;
}

QString NumberField::explained() const {
    if (!m_refusal.isEmpty()) return m_refusal;
    QStringList lines;
    if (isCut()) lines << text();
    if (!toolTip().isEmpty()) lines << toolTip();
    if (isEnabled() && !isReadOnly()) lines << limitsText();
    lines.removeAll({});
    return lines.join('\n');
}

bool NumberField::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), explained(), this);
        return true;
    }
    const bool handled = QLineEdit::event(event);
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        // While something is typed, Escape is the field's, whatever else it does in the window.
        if (isModified() && key->key() == Qt::Key_Escape) event->accept();
        // Nothing was typed that could be undone here: the keys are the document's.
        if (!isModified() && (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)))
            event->ignore();
        // Qt takes it for the end of the line, where End goes as well.
        if (key->modifiers() == Qt::ControlModifier && key->key() == Qt::Key_E) event->ignore();
    }
    return handled;
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
    m_keys.goOn();
    take(*m_value + direction * step * (event->modifiers() & Qt::ShiftModifier ? 10 : 1));
    selectAll();
}

/// Words end at a number's point and before its unit.
void NumberField::mouseDoubleClickEvent(QMouseEvent* event) {
    QLineEdit::mouseDoubleClickEvent(event); // which looks out for a third click
    if (event->button() == Qt::LeftButton) selectAll();
}

void NumberField::focusInEvent(QFocusEvent* event) {
    QLineEdit::focusInEvent(event);
    // After the mouse press that gave the focus has placed its cursor.
    QTimer::singleShot(0, this, &QLineEdit::selectAll);
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    m_keys.finish();
}

void NumberField::takeTyped() {
    if (!isModified()) return;
    const auto typed = readNumber(text());
    if (!typed) return refuse(tr("This is not a number."));
    const auto ratio = typed->unit.isEmpty() ? std::optional(1.0) : unitRatio(typed->unit, m_format.unit);
    if (!ratio && m_format.unit.isEmpty())
        return refuse(tr("“%1” is not understood: the number has no unit.").arg(typed->unit));
    if (!ratio) return refuse(tr("“%1” is not understood: the unit is %2.").arg(typed->unit, m_format.unit));
    const double value = typed->number * *ratio / m_format.shownPerValue;
    if (value < m_format.minimum || value > m_format.maximum) return refuse(rangeText());
    m_keys.finish();
    take(value);
    emit gestureFinished();
}

void NumberField::take(double value) {
    value = std::clamp(value, m_format.minimum, m_format.maximum);
    const bool changed = m_value != value;
    m_value = value;
    showValue();
    if (changed) emit valueEdited(value);
}

void NumberField::refuse(const QString& reason) {
    setRefusal(reason);
    if (hasFocus()) selectAll();
    // The focus that comes to another field would hide the tool tip.
    QTimer::singleShot(0, this, &NumberField::tellRefusal);
}

void NumberField::tellRefusal() {
    if (m_refusal.isEmpty() || !isVisible()) return;
    QToolTip::showText(mapToGlobal(QPoint(0, height())), m_refusal, this);
}

void NumberField::setRefusal(const QString& reason) {
    if (reason == m_refusal) return;
    m_refusal = reason;
    setProperty("refused", !reason.isEmpty());
    setAccessibleDescription(reason);
    style()->polish(this);
    if (reason.isEmpty()) QToolTip::hideText();
    emit refusalChanged();
}

void NumberField::showValue() {
    setRefusal({});
    QString shown = m_emptyText;
    if (m_value) {
        const double number = *m_value * m_format.shownPerValue;
        shown = m_format.decimals < 0 ? numberText(number) : decimalText(number, m_format.decimals);
        if (m_format.showsUnit && !m_format.unit.isEmpty()) shown += ' ' + m_format.unit;
    }
    setText(shown);
    setCursorPosition(0);
    setModified(false);
}

QString NumberField::boundText(double value) const {
    return QString::number(value * m_format.shownPerValue, 'g', 10).replace('-', QChar(0x2212));
}

QString NumberField::rangeText() const {
    const QString unit = m_format.unit.isEmpty() ? QString() : ' ' + m_format.unit;
    if (m_format.maximum == std::numeric_limits<double>::max())
        return tr("The value must be at least %1%2.").arg(boundText(m_format.minimum), unit);
    return tr("The value must lie between %1 and %2%3.")
        .arg(boundText(m_format.minimum), boundText(m_format.maximum), unit);
}

QString NumberField::limitsText() const {
    const QString unit = m_format.unit.isEmpty() ? QString() : ' ' + m_format.unit;
    if (m_format.minimum == std::numeric_limits<double>::lowest())
        return m_format.unit.isEmpty() ? QString() : tr("In %1").arg(m_format.unit);
    const QString least = boundText(m_format.minimum);
    if (m_format.maximum == std::numeric_limits<double>::max()) return tr("At least %1%2").arg(least, unit);
    return tr("From %1 to %2%3").arg(least, boundText(m_format.maximum), unit);
}

} // namespace esm
