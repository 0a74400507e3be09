#include "app/editor/panels/texture/mask_pages.h"

#include "app/editor/panels/texture/page_row.h"
#include "widgets/inputs/quantity_formats.h"
#include "widgets/inputs/quiet_label.h"

#include <QShortcut>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double usualTolerance = 12;

NumberFormat radiusFormat() {
    NumberFormat format = pixelFormat();
    format.minimum = 1;
    format.maximum = 2000;
    return format;
}

NumberFormat toleranceFormat() {
    NumberFormat format;
    format.decimals = 0;
    format.minimum = 1;
    format.maximum = 100;
    format.step = 1;
    return format;
}

} // namespace

BrushPage::BrushPage(PhotoCanvas& canvas, QWidget* parent)
    : QWidget(parent), m_canvas(canvas), m_radius(new NumberField(radiusFormat(), this)),
      m_softness(new NumberField(shareFormat(), this)) {
    QHBoxLayout* row = pageRow(this);
    m_radius->setObjectName(QStringLiteral("photoBrushRadius"));
    m_radius->setToolTip(tr("Of the brush, in pixels of the photo; [ and ] make it smaller and larger"));
    m_softness->setToolTip(tr("Share of the radius over which the brush fades"));
    m_radius->setValue(20);
    m_softness->setValue(0.3);
    row->addWidget(quietLabel(tr("&Radius"), this, m_radius));
    row->addWidget(m_radius);
    row->addWidget(quietLabel(tr("So&ftness"), this, m_softness));
    row->addWidget(m_softness);
    row->addStretch();
    for (NumberField* field : {m_radius, m_softness}) {
        field->setMaximumWidth(pageNumberWidth);
        connect(field, &NumberField::valueEdited, this, [this] { change(1); });
    }
    for (const auto& [key, factor] : {std::pair(Qt::Key_BracketLeft, 0.8), {Qt::Key_BracketRight, 1.25}})
        connect(new QShortcut(key, window()), &QShortcut::activated, this,
                [this, factor = factor] { change(factor); });
    change(1);
}

void BrushPage::fitTo(const Image& photo) {
    m_radius->setValue(std::max(3.0, std::round(std::max(photo.width, photo.height) / 60.0)));
    change(1);
}

void BrushPage::change(double factor) {
    const NumberFormat& format = m_radius->format();
    const double radius = std::clamp(std::round(*m_radius->value() * factor), format.minimum, format.maximum);
    if (factor != 1) m_radius->setValue(radius);
    m_canvas.setBrush({radius, *m_softness->value()});
}

OutlinePage::OutlinePage(PreparationEdits& edits, QWidget* parent) : QWidget(parent) {
    QHBoxLayout* row = pageRow(this);
    auto* find = new QPushButton(tr("&Find text and boxes"), this);
    find->setObjectName(QStringLiteral("findOverlays"));
    find->setAutoDefault(false);
    find->setToolTip(tr("Erase what a camera's software wrote into the photo"));
    row->addWidget(find);
    row->addStretch();
    connect(find, &QPushButton::clicked, this, [&edits] {
        edits.edit(tr("Erase text and boxes"), [](PreparationWish& wish) { wish.find.overlays = true; });
    });
}

RegionPage::RegionPage(PreparationEdits& edits, QWidget* parent)
    : QWidget(parent), m_edits(edits), m_tolerance(new NumberField(toleranceFormat(), this)) {
    QHBoxLayout* row = pageRow(this);
    m_tolerance->setObjectName(QStringLiteral("regionTolerance"));
    m_tolerance->setMaximumWidth(pageNumberWidth);
    m_tolerance->setToolTip(
        tr("How much colours may differ from the one that is clicked: 1 is hardly seen, 100 is "
           "black and white"));
    m_tolerance->setValue(usualTolerance);
    row->addWidget(quietLabel(tr("&Tolerance"), this, m_tolerance));
    row->addWidget(m_tolerance);
    row->addStretch();
}

void RegionPage::grow(const Eigen::Vector2d& place) {
    const RegionSeed seed{place, *m_tolerance->value()};
    m_edits.edit(tr("Erase region of photo"), [=](PreparationWish& wish) { wish.find.region = seed; });
}

} // namespace esm
