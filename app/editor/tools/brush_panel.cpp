#include "app/editor/tools/brush_panel.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/tools/size_keys.h"
#include "core/texture/texture_limits.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quantity_formats.h"

#include <QColorDialog>

#include <algorithm>

namespace esm {

namespace {

QString kindName(BrushKind kind) {
    switch (kind) {
    case BrushKind::Erase:
        return BrushPanel::tr("erase");
    case BrushKind::Restore:
        return BrushPanel::tr("restore");
    case BrushKind::Colour:
        return BrushPanel::tr("colour");
    case BrushKind::Clone:
        return BrushPanel::tr("clone");
    case BrushKind::Heal:
        return BrushPanel::tr("heal");
    }
    return {};
}

QColor shownColour(const std::array<std::uint8_t, 3>& colour) {
    return {colour[0], colour[1], colour[2]};
}

} // namespace

BrushPanel::BrushPanel(Painting& painting, QWidget* parent)
    : Section(tr("Brush"), parent), m_painting(painting), m_kind(new QComboBox(this)),
      m_radius(new NumberField(lengthFormat(texture_limits::shortestPhoto), this)),
      m_softness(new NumberField(shareFormat(), this)), m_strength(new NumberField(shareFormat(), this)),
      m_pressureSize(new QCheckBox(tr("size"), this)),
      m_pressureStrength(new QCheckBox(tr("strength"), this)), m_colour(new QPushButton(this)),
      m_remark(new QLabel(this)) {
    layOut();
    connectFields();
    connect(&painting, &Painting::changed, this, &BrushPanel::show);
    show();
}

void BrushPanel::layOut() {
    auto* rows = new ValueRows(this);
    rows->addField(tr("Does"), m_kind);
    rows->addField(tr("Radius"), m_radius);
    rows->addField(tr("Softness"), m_softness);
    rows->addField(tr("Strength"), m_strength);
    rows->addField(tr("Pen pressure"), pressureBoxes());
    rows->addField(tr("Colour"), m_colour);
    m_kind->setObjectName(QStringLiteral("brushKind"));
    m_radius->setObjectName(QStringLiteral("brushRadius"));
    m_colour->setObjectName(QStringLiteral("brushColour"));
    m_remark->setObjectName(QStringLiteral("brushRemark"));
    m_remark->setProperty("quiet", true);
    m_remark->setWordWrap(true);
    m_remark->setAlignment(Qt::AlignTop);
    m_remark->setMinimumHeight(2 * m_remark->fontMetrics().lineSpacing());
    guardFromWheel(*m_kind);
    body()->addWidget(rows);
    body()->addWidget(m_remark);
}

QWidget* BrushPanel::pressureBoxes() {
    auto* boxes = new QWidget(this);
    auto* row = new QHBoxLayout(boxes);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_pressureSize->setObjectName(QStringLiteral("pressureSize"));
    m_pressureSize->setAccessibleName(tr("Pen pressure changes size"));
    m_pressureStrength->setObjectName(QStringLiteral("pressureStrength"));
    m_pressureStrength->setAccessibleName(tr("Pen pressure changes strength"));
    for (QCheckBox* box : {m_pressureSize, m_pressureStrength}) {
        row->addWidget(box);
        connect(box, &QCheckBox::clicked, this, &BrushPanel::usePressure);
    }
    return boxes;
}

void BrushPanel::usePressure() {
    m_painting.setPressureUse({m_pressureSize->isChecked(), m_pressureStrength->isChecked()});
}

void BrushPanel::connectFields() {
    connect(m_kind, qOverload<int>(&QComboBox::activated), this, [this] {
        const auto kind = static_cast<BrushKind>(m_kind->currentData().toInt());
        change([kind](Painting::Brush& brush) { brush.kind = kind; });
    });
    connect(m_radius, &NumberField::valueEdited, this,
            [this](double metres) { change([metres](Painting::Brush& brush) { brush.radius = metres; }); });
    connect(m_softness, &NumberField::valueEdited, this,
            [this](double share) { change([share](Painting::Brush& brush) { brush.softness = share; }); });
    connect(m_strength, &NumberField::valueEdited, this,
            [this](double share) { change([share](Painting::Brush& brush) { brush.strength = share; }); });
    connect(m_colour, &QPushButton::clicked, this, &BrushPanel::chooseColour);
    sizeByBrackets(*this, [this](double factor) { resizeBrush(factor); });
}

void BrushPanel::change(const std::function<void(Painting::Brush&)>& change) {
    Painting::Brush brush = m_painting.brush();
    change(brush);
    m_painting.setBrush(brush);
}

void BrushPanel::resizeBrush(double factor) {
    change(
        [factor](Painting::Brush& brush) { brush.radius = std::max(factor * brush.radius, smallestLength); });
}

void BrushPanel::chooseColour() {
    const QColor chosen = ask(*window(), [&] {
        return QColorDialog::getColor(shownColour(m_painting.brush().colour), window(),
                                      tr("Colour of the brush"));
    });
    if (!chosen.isValid()) return;
    change([&](Painting::Brush& brush) {
        brush.colour = {static_cast<std::uint8_t>(chosen.red()), static_cast<std::uint8_t>(chosen.green()),
                        static_cast<std::uint8_t>(chosen.blue())};
    });
}

void BrushPanel::show() {
    const QString none = tr("No layer is selected");
    const bool hasLayer = m_painting.layer() != nullptr;
    const Painting::Brush brush = m_painting.brush();
    showKinds();
    enable(m_radius, hasLayer, tr("Of the brush on the organ; [ and ] make it smaller and larger"), none);
    enable(m_softness, hasLayer, tr("Share of the radius over which the brush fades"), none);
    enable(m_strength, hasLayer, tr("How much the middle of the brush covers"), none);
    NumberFormat radius = m_radius->format();
    radius.maximum = m_painting.largestRadius();
    m_radius->setFormat(radius);
    m_radius->setValue(brush.radius);
    m_softness->setValue(brush.softness);
    m_strength->setValue(brush.strength);
    m_pressureSize->setChecked(m_painting.pressureUse().size);
    m_pressureStrength->setChecked(m_painting.pressureUse().strength);
    enable(m_pressureSize, hasLayer,
           tr("The lighter a tablet's pen presses, the smaller the brush; the mouse paints in full"), none);
    enable(m_pressureStrength, hasLayer,
           tr("The lighter a tablet's pen presses, the less it covers; the mouse paints in full"), none);
    enable(m_colour, hasLayer && brush.kind == BrushKind::Colour, tr("The colour that is laid on the organ"),
           hasLayer ? tr("Only the colour brush has one") : none);
    showColour(brush.colour);
    m_remark->setText(remark());
}

void BrushPanel::showKinds() {
    const std::vector<BrushKind> kinds = m_painting.kinds();
    m_kind->clear();
    for (const BrushKind kind : kinds)
        m_kind->addItem(kindName(kind), static_cast<int>(kind));
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(m_painting.brush().kind)));
    enable(m_kind, !kinds.empty(), tr("What the brush does to the selected layer"),
           tr("No layer is selected"));
}

void BrushPanel::showColour(const std::array<std::uint8_t, 3>& colour) {
    QPixmap swatch(28, 14);
    swatch.fill(m_colour->isEnabled() ? shownColour(colour) : Qt::transparent);
    m_colour->setIcon(swatch);
    m_colour->setIconSize(swatch.size());
    m_colour->setText(m_colour->isEnabled() ? shownColour(colour).name() : QString(QChar(0x2013)));
}

QString BrushPanel::remark() const {
    if (!m_painting.layer()) return {};
    if (m_painting.layer()->photo)
        return tr("A photo is erased and restored. Colours are laid on a paint layer: the brush beside "
                  "“+ add” adds one.");
    const BrushKind kind = m_painting.brush().kind;
    if (!copies(kind)) return {};
    if (!m_painting.source()) return tr("Ctrl and a click on the organ say where it takes its colours.");
    return kind == BrushKind::Heal ? tr("Takes details from the cross, and the shade from around the stroke. "
                                        "Ctrl and a click move it.")
                                   : tr("Each stroke begins at the cross. Ctrl and a click move it.");
}

} // namespace esm
