#include "app/editor/panels/texture/adjust_page.h"

#include "app/editor/panels/texture/page_row.h"
#include "widgets/inputs/action_texts.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"
#include "widgets/inputs/quiet_label.h"

#include <QSignalBlocker>

#include <algorithm>

namespace esm {

namespace {

constexpr int columnsOfControl = 3, controlsInRow = 3;

NumberFormat numberFrom(double least, double most, double step, int decimals, const QString& unit = {}) {
    NumberFormat format;
    format.unit = unit;
    format.minimum = least;
    format.maximum = most;
    format.step = step;
    format.decimals = decimals;
    return format;
}

QString shownText(const NumberFormat& format, double value) {
    const QString number = decimalText(value * format.shownPerValue, format.decimals);
    return format.unit.isEmpty() ? number : number + QChar(0x202f) + format.unit;
}

} // namespace

AdjustPage::AdjustPage(PreparationEdits& edits, QWidget* parent)
    : QWidget(parent), m_edits(edits), m_grid(new QGridLayout(this)),
      m_reset(new QPushButton(tr("&Reset"), this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(8);
    add(tr("&Hue"), &ColourAdjustment::hue, "photoHue", numberFrom(-180, 180, 1, 0, QStringLiteral("°")), 360)
        .field->setToolTip(tr("Turns red towards yellow, or below zero towards magenta; brightness stays"));
    add(tr("&Saturation"), &ColourAdjustment::saturation, "photoSaturation", wholePercentFormat(2, 0.01), 200)
        .field->setToolTip(tr("From 0 %, grey, to 200 %, twice as colourful; brightness stays"));
    add(tr("&Contrast"), &ColourAdjustment::contrast, "photoContrast", wholePercentFormat(2, 0.01), 200)
        .field->setToolTip(tr("How far dark and bright lie apart, about middle grey"));
    add(tr("&Black point"), &ColourAdjustment::blackPoint, "photoBlackPoint", numberFrom(0, 254, 1, 0), 254)
        .field->setToolTip(tr("What has this value of 0 to 255, or less, becomes black"));
    add(tr("&White point"), &ColourAdjustment::whitePoint, "photoWhitePoint", numberFrom(1, 255, 1, 0), 254)
        .field->setToolTip(tr("What has this value of 0 to 255, or more, becomes white"));
    const Control& gamma =
        add(tr("&Gamma"), &ColourAdjustment::gamma, "photoGamma", numberFrom(0.1, 10, 0.05, 2), 200);
    gamma.slider->setLogarithmicScale(0.1, 10);
    gamma.field->setToolTip(tr("Above 1 what lies between black and white becomes brighter, below 1 darker"));
    for (const Control& control : m_controls) {
        control.slider->setToolTip(control.field->toolTip());
        connectControl(control);
    }
    m_reset->setObjectName(QStringLiteral("resetAdjustment"));
    m_reset->setAutoDefault(false);
    m_grid->addWidget(m_reset, 0, controlsInRow * columnsOfControl, 2, 1, Qt::AlignVCenter);
    connect(m_reset, &QPushButton::clicked, this, &AdjustPage::reset);
}

AdjustPage::Control& AdjustPage::add(const QString& caption, double ColourAdjustment::*part, const char* name,
                                     const NumberFormat& format, int steps) {
    auto* slider = new ValueSlider(this);
    auto* field = new NumberField(format, this);
    field->setObjectName(QLatin1String(name));
    field->setMaximumWidth(pageNumberWidth);
    field->setAccessibleName(withoutMnemonic(caption));
    slider->setObjectName(QLatin1String(name) + QLatin1String("Slider"));
    slider->setAccessibleName(withoutMnemonic(caption));
    slider->setRange(0, steps);
    slider->setMinimumWidth(80);
    slider->setScale(format.minimum * format.shownPerValue, format.maximum * format.shownPerValue);
    const int number = static_cast<int>(m_controls.size());
    const int row = number / controlsInRow, column = number % controlsInRow * columnsOfControl;
    m_grid->addWidget(quietLabel(caption, this, field), row, column);
    m_grid->addWidget(slider, row, column + 1);
    m_grid->addWidget(field, row, column + 2);
    m_grid->setColumnStretch(column + 1, 1);
    return m_controls.emplace_back(Control{part, slider, field});
}

void AdjustPage::connectControl(const Control& control) {
    const auto& [part, slider, field] = control;
    connect(slider, &QSlider::valueChanged, this, [this, part = part, slider = slider, field = field] {
        set(part, slider->scaledValue() / field->format().shownPerValue);
    });
    connect(field, &NumberField::valueEdited, this, [this, part = part](double value) { set(part, value); });
    connect(slider, &ValueSlider::gestureFinished, &m_edits, &PreparationEdits::finishGesture);
    connect(field, &NumberField::gestureFinished, &m_edits, &PreparationEdits::finishGesture);
}

/// The black point gives way to the white one and the other way round, whichever is not being set.
void AdjustPage::set(double ColourAdjustment::*part, double value) {
    ColourAdjustment wanted = m_edits.wanted().preparation.adjustment;
    wanted.*part = value;
    if (part == &ColourAdjustment::blackPoint)
        wanted.whitePoint = std::max(wanted.whitePoint, value + 1);
    else
        wanted.blackPoint = std::min(wanted.blackPoint, wanted.whitePoint - 1);
    m_edits.edit(
        tr("Adjust colours"), [=](PreparationWish& wish) { wish.preparation.adjustment = wanted; },
        EditKind::Adjustment);
}

void AdjustPage::reset() {
    m_edits.edit(tr("Reset colours"), [](PreparationWish& wish) { wish.preparation.adjustment = {}; });
    m_edits.finishGesture();
}

void AdjustPage::showAdjustment() {
    const ColourAdjustment wanted = m_edits.wanted().preparation.adjustment;
    for (const auto& [part, slider, field] : m_controls) {
        const QSignalBlocker noEdit(slider);
        const double value = wanted.*part;
        slider->setScaledValue(value * field->format().shownPerValue);
        slider->setSpoken(shownText(field->format(), value));
        field->setValue(value);
    }
    enable(m_reset, wanted != ColourAdjustment(), tr("Take the photo's colours as they were"),
           tr("The colours are as they were"));
}

QString adjustmentText(const ColourAdjustment& adjustment) {
    const ColourAdjustment none;
    QStringList words;
    if (adjustment.hue != none.hue) words << AdjustPage::tr("hue %1°").arg(decimalText(adjustment.hue, 0));
    if (adjustment.saturation != none.saturation)
        words << AdjustPage::tr("saturation %1 %").arg(decimalText(100 * adjustment.saturation, 0));
    if (adjustment.contrast != none.contrast)
        words << AdjustPage::tr("contrast %1 %").arg(decimalText(100 * adjustment.contrast, 0));
    if (adjustment.blackPoint != none.blackPoint || adjustment.whitePoint != none.whitePoint ||
        adjustment.gamma != none.gamma)
        words << AdjustPage::tr("levels %1 to %2, gamma %3")
                     .arg(decimalText(adjustment.blackPoint, 0), decimalText(adjustment.whitePoint, 0),
                          decimalText(adjustment.gamma, 2));
    return words.join(QStringLiteral(", "));
}

} // namespace esm
