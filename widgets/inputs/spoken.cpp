#include "widgets/inputs/spoken.h"

#include <QAccessibleWidget>
#include <QLabel>

namespace esm {

namespace {

class SpokenInterface : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    SpokenInterface(QWidget* widget, Spoken& spoken)
        : QAccessibleWidget(widget, spoken.spokenRole()), m_spoken(spoken) {}

    QString text(QAccessible::Text kind) const override {
        if (kind == QAccessible::Value) return m_spoken.spokenValue();
        QString usual = QAccessibleWidget::text(kind);
        if (kind != QAccessible::Description) return usual;
        // Values that are no numbers are not passed on to readers on a desktop of Linux.
        return usual.isEmpty() ? m_spoken.spokenValue()
                               : m_spoken.spokenValue() + QStringLiteral(". ") + usual;
    }
    void* interface_cast(QAccessible::InterfaceType type) override {
        if (type == QAccessible::ValueInterface && m_spoken.spokenNumber())
            return static_cast<QAccessibleValueInterface*>(this);
        return QAccessibleWidget::interface_cast(type);
    }

    QVariant currentValue() const override { return number().value; }
    void setCurrentValue(const QVariant& value) override { m_spoken.setSpokenNumber(value.toDouble()); }
    QVariant minimumValue() const override { return number().minimum; }
    QVariant maximumValue() const override { return number().maximum; }
    QVariant minimumStepSize() const override { return number().step; }

private:
    SpokenNumber number() const { return m_spoken.spokenNumber().value_or(SpokenNumber{}); }

    Spoken& m_spoken;
};

/// Never seen, and always beside the choice that it names, where readers look for it.
class UnseenLabel : public QLabel {
public:
    UnseenLabel(QComboBox& choice, const QString& name)
        : QLabel(name, choice.parentWidget()), m_choice(choice) {
        setBuddy(&choice);
        hide();
        choice.installEventFilter(this);
        connect(&choice, &QObject::destroyed, this, &QObject::deleteLater);
    }

    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::ParentChange) setParent(m_choice.parentWidget());
        return false;
    }

private:
    QComboBox& m_choice;
};

QAccessibleInterface* spokenInterface(const QString&, QObject* object) {
    auto* spoken = dynamic_cast<Spoken*>(object);
    auto* widget = qobject_cast<QWidget*>(object);
    return spoken && widget ? new SpokenInterface(widget, *spoken) : nullptr;
}

} // namespace

Spoken::Spoken() {
    [[maybe_unused]] static const bool isInstalled = [] {
        QAccessible::installFactory(spokenInterface);
        return true;
    }();
}

void nameChoice(QComboBox& choice, const QString& name) {
    choice.setAccessibleName(name);
    new UnseenLabel(choice, name);
}

} // namespace esm
