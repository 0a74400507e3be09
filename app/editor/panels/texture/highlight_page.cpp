#include "app/editor/panels/texture/highlight_page.h"

#include "app/editor/panels/texture/page_row.h"
#include "core/texture/photo/highlights.h"
#include "widgets/inputs/quiet_label.h"

#include <QSignalBlocker>

#include <cmath>

namespace esm {

namespace {

constexpr int steps = 100; ///< of the slider

} // namespace

HighlightPage::HighlightPage(PreparationEdits& edits, PhotoCanvas& canvas, QWidget* parent)
    : QWidget(parent), m_edits(edits), m_canvas(canvas), m_fills(new QCheckBox(tr("&Fill highlights"), this)),
      m_slider(new ValueSlider(this)), m_words(new QLabel(this)) {
    m_fills->setObjectName(QStringLiteral("fillHighlights"));
    m_fills->setToolTip(tr("Fill what the lamp burnt out from the tissue around it"));
    m_slider->setObjectName(QStringLiteral("highlightSensitivity"));
    m_slider->setOrientation(Qt::Horizontal);
    m_slider->setRange(0, steps);
    m_slider->setMinimumWidth(160);
    m_slider->setAccessibleName(tr("Sensitivity to highlights"));
    m_slider->setToolTip(tr("From only what is white to faint shine as well; what is green would be filled"));
    m_words->setProperty("quiet", true);
    QHBoxLayout* row = pageRow(this);
    row->addWidget(m_fills);
    row->addWidget(quietLabel(tr("&Sensitivity"), this, m_slider));
    row->addWidget(m_slider);
    row->addWidget(m_words);
    row->addStretch();
    connect(m_fills, &QCheckBox::clicked, this, &HighlightPage::fill);
    connect(m_slider, &QSlider::valueChanged, this, &HighlightPage::mark);
    connect(m_slider, &ValueSlider::gestureFinished, this, [this] {
        if (m_fills->isChecked()) fill();
    });
    connect(&m_finder, &HighlightFinder::found, this, [this] {
        const TextureLayer* layer = m_edits.layer();
        if (layer && isVisible()) m_canvas.setMarked(m_finder.maskOf(layer->photo));
    });
}

double HighlightPage::sensitivity() const {
    return m_slider->value() / static_cast<double>(steps);
}

void HighlightPage::mark() {
    m_words->setText(QLocale::c().toString(sensitivity(), 'f', 2));
    m_slider->setSpoken(m_words->text());
    const TextureLayer* layer = m_edits.layer();
    if (!layer || !isVisible()) return;
    PhotoPreparation preparation = m_edits.wanted().preparation;
    preparation.highlightSensitivity = sensitivity();
    m_canvas.setMarked(m_finder.maskOf(layer->photo)); // none of another photo
    m_finder.find(layer->photo, preparation);
}

void HighlightPage::fill() {
    const auto wanted = m_fills->isChecked() ? std::optional(sensitivity()) : std::nullopt;
    m_edits.edit(
        wanted ? tr("Fill highlights") : tr("Show highlights"),
        [=](PreparationWish& wish) {
            wish.preparation.highlightThreshold.reset();
            wish.preparation.highlightSensitivity = wanted;
        },
        EditKind::Highlights);
    m_edits.finishGesture();
}

void HighlightPage::showHighlights() {
    const PhotoPreparation wanted = m_edits.wanted().preparation;
    m_fills->setChecked(wanted.fillsHighlights());
    const double shown = wanted.highlightSensitivity.value_or(usualSensitivity);
    const QSignalBlocker noEdit(m_slider);
    if (wanted.highlightSensitivity || !isVisible())
        m_slider->setValue(static_cast<int>(std::lround(steps * shown)));
    mark();
}

void HighlightPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    mark();
}

void HighlightPage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_canvas.setMarked({});
}

} // namespace esm
