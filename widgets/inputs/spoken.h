#pragma once

#include <QAccessible>
#include <QComboBox>
#include <QWidget>

#include <optional>

namespace esm {

/// A number as it is shown, and between what it can be set.
struct SpokenNumber {
    double value, minimum, maximum, step;
};

/// What a screen reader says of a widget that we paint ourselves. A widget that inherits this beside QWidget
/// has an accessible interface of its own from the first one on.
class Spoken {
public:
    Spoken();
    virtual ~Spoken() = default;

    /// What the widget shows now, in words and with units: "flexible 0.92, 1.2 N/m". Never empty.
    virtual QString spokenValue() const = 0;
    /// Where a number is set.
    virtual std::optional<SpokenNumber> spokenNumber() const { return std::nullopt; }
    virtual void setSpokenNumber(double) {}
    virtual QAccessible::Role spokenRole() const { return QAccessible::Graphic; }

protected:
    Spoken(const Spoken&) = default;
    Spoken& operator=(const Spoken&) = default;
};

/// Tells screen readers that what a widget says of itself is another now.
template<typename Widget> void tellSpoken(Widget& widget) {
    if (!QAccessible::isActive()) return;
    QAccessibleValueChangeEvent value(&widget, widget.spokenValue());
    QAccessible::updateAccessibility(&value);
    // Readers on a desktop of Linux know texts as descriptions alone.
    QAccessibleEvent description(&widget, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&description);
}

/// What a choice without a caption is called. Its accessible name is not enough: on a desktop of Linux that
/// is what is chosen, and what is called a name comes from a label.
void nameChoice(QComboBox& choice, const QString& name);

} // namespace esm
