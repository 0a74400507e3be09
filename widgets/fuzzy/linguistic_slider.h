#pragma once

#include "core/fuzzy/fuzzy_system.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/value_slider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace esm {

/// A linguistic variable: its name, a number field with the unit, a slider over its range and its terms
/// beneath. What is set lies in the range that may be typed.
class LinguisticSlider : public QWidget {
    Q_OBJECT

public:
    /// @param format unit and limits of the number; without a step, a hundredth of the variable's range
    LinguisticSlider(const FuzzyVariable& variable, const QString& caption, NumberFormat format,
                     QWidget* parent = nullptr);

    /// Shows a value without announcing it. Without one the slider waits in the middle.
    void setValue(std::optional<double> value);
    /// In place of the terms, for a variable that has no value.
    void setNote(const QString& note) { m_terms->setNote(note); }
    /// Adds a checkable button beside the number that holds it at a value set by hand.
    QToolButton* addHoldButton();

    NumberField* field() const { return m_field; }
    ValueSlider* slider() const { return m_slider; }

signals:
    void valueEdited(double value);
    /// The slider came to rest, or a value was typed: what follows is another edit.
    void editingFinished();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void takeSlider(int position);
    void take(double value);
    double withinLimits(double value) const;

    FuzzyVariable m_variable;
    NumberField* m_field;
    ValueSlider* m_slider;
    TermScale* m_terms;
    QHBoxLayout* m_header;
};

} // namespace esm
