#include "tests/app/access_complaints.h"

#include "widgets/inputs/number_field.h"
#include "widgets/inputs/spoken.h"
#include "widgets/view/organ_view.h"
#include "widgets/view/photo_view.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QKeySequence>
#include <QLabel>
#include <QMap>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QToolTip>

namespace {

using namespace esm;

const QString noToolTip = QStringLiteral("no tool tip came");

/// Made by Qt within a control that is looked at as a whole.
bool isPartOfControl(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    return qobject_cast<const QScrollBar*>(&widget) || qobject_cast<const QComboBox*>(parent) ||
           qobject_cast<const QTabBar*>(parent) || qobject_cast<const QAbstractItemView*>(parent) ||
           widget.objectName().startsWith(QLatin1String("qt_"));
}

bool takesKeysOrClicks(const QWidget& widget) {
    // A text that can be copied is read as it stands.
    if (qobject_cast<const QLabel*>(&widget) || isPartOfControl(widget)) return false;
    // The window keeps the place of tabs that another workspace has.
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) return tabs->count() > 0;
    return widget.focusPolicy() != Qt::NoFocus || qobject_cast<const QAbstractButton*>(&widget) ||
           dynamic_cast<const Spoken*>(&widget);
}

bool hasWord(const QString& text) {
    for (const QChar letter : text)
        if (letter.isLetter()) return true;
    return false;
}

/// What is chosen stands for the name of a choice: who hears it needs a label.
bool isNamed(const QWidget& widget, const QAccessibleInterface& heard) {
    if (!qobject_cast<const QComboBox*>(&widget)) return hasWord(heard.text(QAccessible::Name));
    const auto labels = heard.relations(QAccessible::Label);
    return !labels.isEmpty() && hasWord(labels.front().first->text(QAccessible::Name));
}

/// As the mouse finds it that rests in the middle.
QString toolTipShown(QWidget& widget) {
    auto* area = qobject_cast<QAbstractScrollArea*>(&widget);
    QWidget* asked = area ? area->viewport() : &widget;
    const QPoint middle = asked->rect().center();
    QToolTip::showText({}, noToolTip, &widget);
    QHelpEvent event(QEvent::ToolTip, middle, asked->mapToGlobal(middle));
    QCoreApplication::sendEvent(asked, &event);
    return QToolTip::text() == noToolTip ? QString() : QToolTip::text();
}

bool rowsHaveNames(const QAbstractItemView& view) {
    const QAbstractItemModel* model = view.model();
    for (int row = 0; model && row < model->rowCount(); ++row) {
        const QModelIndex index = model->index(row, 0);
        if (!hasWord(index.data(Qt::AccessibleTextRole).toString()) &&
            !hasWord(index.data(Qt::DisplayRole).toString()))
            return false;
    }
    return true;
}

bool tabsAreExplained(const QTabBar& tabs) {
    for (int tab = 0; tab < tabs.count(); ++tab)
        if (!hasWord(tabs.tabText(tab)) || tabs.tabToolTip(tab).isEmpty()) return false;
    return true;
}

bool headersAreExplained(const QAbstractItemView& view) {
    for (const QHeaderView* header : view.findChildren<QHeaderView*>()) {
        if (header->isHidden()) continue;
        for (int section = 0; section < header->count(); ++section)
            if (header->model()
                    ->headerData(section, header->orientation(), Qt::ToolTipRole)
                    .toString()
                    .isEmpty())
                return false;
    }
    return true;
}

QString valueComplaint(QWidget& widget, QAccessibleInterface& heard) {
    const QString value = heard.text(QAccessible::Value);
    if (const auto* view = qobject_cast<QAbstractItemView*>(&widget)) {
        if (!rowsHaveNames(*view)) return "rows without names";
        return headersAreExplained(*view) ? QString() : "headers without tool tips";
    }
    if (const auto* tabs = qobject_cast<QTabBar*>(&widget))
        return tabsAreExplained(*tabs) ? QString() : "tabs without names or tool tips";
    if (const auto* choice = qobject_cast<QComboBox*>(&widget))
        return choice->currentText().isEmpty() == value.isEmpty() ? QString() : "choice without a value";
    if (const auto* number = qobject_cast<NumberField*>(&widget)) {
        const QString said = heard.text(QAccessible::Name) + value;
        const bool isSaid = !number->value() || said.contains(number->format().unit);
        return isSaid && !value.isEmpty() ? QString() : "number without unit";
    }
    if (dynamic_cast<Spoken*>(&widget)) return value.isEmpty() ? "says nothing of what it shows" : QString();
    const bool isUnknown = heard.role() == QAccessible::Client && !qobject_cast<QScrollArea*>(&widget);
    const bool needsValue = qobject_cast<QAbstractSlider*>(&widget) || isUnknown;
    return needsValue ? "is not known to screen readers" : QString();
}

/// Not by its limits alone, nor only where it can be used. What is worked in with the mouse says in itself
/// what to do, in place of a tool tip that would cover it.
bool isExplained(QWidget& widget) {
    if (const auto* organ = qobject_cast<OrganView*>(&widget)) return !organ->hint().isEmpty();
    if (const auto* photo = qobject_cast<PhotoView*>(&widget)) return !photo->hint().isEmpty();
    if (qobject_cast<NumberField*>(&widget) && !hasWord(widget.toolTip())) return false;
    return qobject_cast<QTabBar*>(&widget) || hasWord(toolTipShown(widget));
}

QString nameOf(const QWidget& widget, const QAccessibleInterface& heard) {
    return QStringLiteral("%1 “%2” “%3” in %4 “%5”")
        .arg(widget.metaObject()->className(), widget.objectName(), heard.text(QAccessible::Name),
             widget.parentWidget() ? widget.parentWidget()->metaObject()->className() : "",
             widget.parentWidget() ? widget.parentWidget()->objectName() : QString());
}

QStringList complaintsAbout(QWidget& widget) {
    QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(&widget);
    if (!heard) return {QString("nothing is known of %1").arg(widget.metaObject()->className())};
    QStringList complaints;
    const QString name = nameOf(widget, *heard);
    if (!isNamed(widget, *heard)) complaints << "no name: " + name;
    if (!isExplained(widget)) complaints << "no tool tip: " + name;
    const QString value = valueComplaint(widget, *heard);
    if (!value.isEmpty()) complaints << value + ": " + name;
    return complaints;
}

QString textWithLetter(const QWidget& widget) {
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
    const auto* label = qobject_cast<const QLabel*>(&widget);
    return label && label->buddy() ? label->text() : QString();
}

/// Alt and a letter that two have only goes from one to the other.
QStringList sharedLetters(QWidget& window) {
    QStringList complaints;
    QMap<QString, QString> taken;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisibleTo(&window) || widget->window() != &window) continue;
        const QString text = textWithLetter(*widget), key = QKeySequence::mnemonic(text).toString();
        if (key.isEmpty()) continue;
        if (taken.contains(key)) complaints << QString("“%1” and “%2” share %3").arg(taken[key], text, key);
        taken[key] = text;
    }
    return complaints;
}

} // namespace

QStringList accessComplaints(QWidget& window) {
    QStringList complaints = sharedLetters(window);
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (widget->isVisibleTo(&window) && widget->window() == &window && takesKeysOrClicks(*widget))
            complaints << complaintsAbout(*widget);
    return complaints;
}
