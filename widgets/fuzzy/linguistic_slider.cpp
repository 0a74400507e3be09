#include "widgets/fuzzy/linguistic_slider.h"

#include "widgets/fuzzy/small_font.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/enabling.h"

#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int sliderSteps = 1000;
constexpr int widestField = 150; // pixels; beyond it the name would have no room

NumberFormat withStep(NumberFormat format, const FuzzyVariable& variable) {
    if (format.step <= 0) format.step = (variable.maximum - variable.minimum) / 100;
    return format;
}

} // namespace

LinguisticSlider::LinguisticSlider(const FuzzyVariable& variable, const QString& caption, NumberFormat format,
                                   QWidget* parent)
    : QWidget(parent), m_variable(variable), m_words(new QLabel(this)),
      m_field(new NumberField(withStep(std::move(format), variable), this)), m_slider(new ValueSlider(this)),
      m_terms(new TermScale(this)), m_header(new QHBoxLayout) {
    auto* name = new ElidedLabel(this);
    name->setText(caption);
    name->setProperty("strong", true);
    name->setBuddy(m_slider);
    m_header->setSpacing(4);
    m_header->addWidget(name, 1);
    const QString& unit = m_field->format().unit;
    // Those with a unit are of one width, so that they line up in a column.
    const int width = m_field->widthFor(unit), usual = m_field->widthFor(QStringLiteral("N·s/m"));
    m_field->setFixedWidth(unit.isEmpty() ? width : std::clamp(width, usual, std::max(usual, widestField)));
    m_header->addWidget(m_field);
    m_slider->setRange(0, sliderSteps);
    m_slider->setPageStep(sliderSteps / 10);
    m_slider->setSingleStep(sliderSteps / 100);
    m_slider->setAccessibleName(caption);
    const double perValue = m_field->format().shownPerValue;
    m_slider->setScale(perValue * variable.minimum, perValue * variable.maximum);
    m_field->setAccessibleName(caption);
    m_slider->setToolTip(tr("Sets %1: drag it, or use the arrow keys").arg(caption));
    m_field->setToolTip(tr("%1 as a number. Up and Down step it").arg(caption));
    m_terms->setAccessibleName(tr("Terms of %1").arg(caption));
    m_terms->setVariable(variable);
    m_words->setObjectName(QStringLiteral("degrees"));
    m_words->setFont(smallFont(font()));
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_words->setWordWrap(true);
    QSizePolicy asTallAsItsText(QSizePolicy::Ignored, QSizePolicy::Fixed);
    asTallAsItsText.setHeightForWidth(true);
    m_words->setSizePolicy(asTallAsItsText);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    column->addLayout(m_header);
    column->addWidget(m_words);
    column->addWidget(m_slider);
    column->addWidget(m_terms);

    connect(m_slider, &QSlider::valueChanged, this, &LinguisticSlider::takeSlider);
    connect(m_slider, &ValueSlider::gestureFinished, this, &LinguisticSlider::editingFinished);
    connect(m_field, &NumberField::valueEdited, this, &LinguisticSlider::take);
    connect(m_field, &NumberField::gestureFinished, this, &LinguisticSlider::editingFinished);
    connect(m_terms, &TermScale::termPicked, this, [this](double value) {
        emit editingFinished(); // of what the keys set a moment ago
        take(value);
        emit editingFinished();
    });
}

void LinguisticSlider::setTerms(const FuzzyVariable& variable) {
    m_variable.terms = variable.terms;
    m_terms->setVariable(m_variable);
    showWords();
}

void LinguisticSlider::setValue(std::optional<double> value) {
    const double range = m_variable.maximum - m_variable.minimum;
    const double fraction = value ? (*value - m_variable.minimum) / range : 0.5;
    const QSignalBlocker quiet(m_slider);
    // A drag in progress keeps the handle under the mouse.
    if (!m_slider->isSliderDown())
        m_slider->setValue(static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * sliderSteps)));
    m_field->setValue(value);
    m_terms->setValue(value);
    showWords();
}

QString LinguisticSlider::words() const {
    return m_field->value() ? wordsFor(m_variable, *m_field->value()) : tr("no value");
}

void LinguisticSlider::showWords() {
    m_words->setText(m_remark.isEmpty() ? words() : words() + QStringLiteral(" · ") + m_remark);
    m_words->setToolTip(m_words->text());
    m_slider->setSpoken(m_field->value() ? m_field->text() + QStringLiteral(", ") + m_words->text()
                                         : m_words->text());
}

void LinguisticSlider::setRemark(const QString& remark, Manner manner) {
    m_remark = remark;
    showWords();
    const bool isHeld = manner == Manner::Held;
    if (m_words->property("held").toBool() == isHeld) return;
    m_words->setProperty("held", isHeld);
    m_words->style()->unpolish(m_words);
    m_words->style()->polish(m_words);
}

void LinguisticSlider::setReadOnly(const QString& reason) {
    for (QWidget* part :
         {static_cast<QWidget*>(m_field), static_cast<QWidget*>(m_slider), static_cast<QWidget*>(m_terms)})
        enable(part, false, {}, reason);
    setToolTip(reason);
}

void LinguisticSlider::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_terms->setInset(m_slider->handleWidth() / 2);
}

QToolButton* LinguisticSlider::addHoldButton() {
    auto* hold = new QToolButton(this);
    hold->setText(tr("hold"));
    hold->setCheckable(true);
    hold->setObjectName(QStringLiteral("holdButton"));
    hold->setAccessibleName(tr("hold %1").arg(m_slider->accessibleName()));
    m_header->insertWidget(1, hold);
    return hold;
}

void LinguisticSlider::takeSlider(int position) {
    const double value = withinLimits(m_variable.minimum + (m_variable.maximum - m_variable.minimum) *
                                                               position / double(sliderSteps));
    m_field->setValue(value);
    m_terms->setValue(value);
    showWords();
    emit valueEdited(value);
}

void LinguisticSlider::take(double value) {
    const double taken = withinLimits(value);
    setValue(taken);
    emit valueEdited(taken);
}

double LinguisticSlider::withinLimits(double value) const {
    return std::clamp(value, m_field->format().minimum, m_field->format().maximum);
}

} // namespace esm
