#pragma once

#include "core/fuzzy/fuzzy_system.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/value_slider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace esm {

/// A linguistic variable: its name, a number field with the unit, the value in words, a slider over its range
/// and its terms beneath. What is set lies in the range that may be typed.
class LinguisticSlider : public QWidget {
    Q_OBJECT

public:
    /// @param format unit and limits of the number; without a step, a hundredth of the variable's range
    LinguisticSlider(const FuzzyVariable& variable, const QString& caption, NumberFormat format,
                     QWidget* parent = nullptr);

    /// Other terms over the same range.
    void setTerms(const FuzzyVariable& variable);
    /// Shows a value without announcing it. Without one the slider waits in the middle.
    void setValue(std::optional<double> value);
    /// In place of the terms, for a variable that has no value.
    void setNote(const QString& note) { m_terms->setNote(note); }
    /// Stands behind the value's words: how the value came about; amber where it was held by hand.
    enum class Manner { Usual, Held };
    void setRemark(const QString& remark, Manner manner);
    /// Adds a checkable button beside the number that holds it at a value set by hand.
    QToolButton* addHoldButton();
    /// The value can only be looked at; the tool tip says why.
    void setReadOnly(const QString& reason);

    /// "flexible 0.92, medium 0.08", or that there is no word for the value.
    QString words() const;

    NumberField* field() const { return m_field; }
    ValueSlider* slider() const { return m_slider; }

signals:
    void valueEdited(double value);
    /// The slider came to rest, or a value was typed: what follows is another edit.
    void editingFinished();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showWords();
    void takeSlider(int position);
    void take(double value);
    double withinLimits(double value) const;

    FuzzyVariable m_variable;
    QString m_remark;
    QLabel* m_words;
    NumberField* m_field;
    ValueSlider* m_slider;
    TermScale* m_terms;
    QHBoxLayout* m_header;
};

} // namespace esm
