#include "app/editor/panels/texture/photo_panel.h"

#include "core/texture/projection/photo_reach.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quantity_formats.h"

#include <QSignalBlocker>
#include <QStandardItemModel>

namespace esm {

QString blendingText(Blending blending) {
    switch (blending) {
    case Blending::Normal:
        return PhotoPanel::tr("normal");
    case Blending::Multiply:
        return PhotoPanel::tr("multiply");
    case Blending::Screen:
        return PhotoPanel::tr("screen");
    case Blending::Overlay:
        return PhotoPanel::tr("overlay");
    case Blending::Colour:
        return PhotoPanel::tr("colour");
    case Blending::MultiBand:
        return PhotoPanel::tr("seamless");
    }
    return {};
}

PhotoPanel::PhotoPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Layer"), parent), m_document(document), m_selection(selection),
      m_visible(new QCheckBox(tr("V&isible"), this)),
      m_occlusion(new QCheckBox(tr("Only what the pro&jector sees"), this)), m_opacity(new ValueSlider(this)),
      m_opacityField(new NumberField(shareFormat(), this)), m_blending(new QComboBox(this)),
      m_blend(new NumberField(pixelFormat(), this)),
      m_miss(new QLabel(tr("The photo misses the organ: nothing of it is seen. Drag it there, or choose "
                           "Photo from camera."),
                        this)) {
    layOut();
    connectControls();
    connect(&selection, &Selection::changed, this, &PhotoPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.layers || change.mesh) show();
    });
    show();
}

void PhotoPanel::layOut() {
    m_opacity->setRange(0, 100);
    m_opacity->setObjectName(QStringLiteral("opacitySlider"));
    m_opacity->setAccessibleName(tr("Opacity"));
    m_opacity->setScale(0, 100);
    auto* rows = new ValueRows(this);
    rows->addField(tr("&Opacity"), m_opacityField);
    body()->addWidget(rows);
    body()->addWidget(m_opacity);
    for (const Blending blending : blendings)
        m_blending->addItem(blendingText(blending));
    guardFromWheel(*m_blending);
    m_blending->setObjectName(QStringLiteral("blending"));
    auto* blendRow = new ValueRows(this);
    blendRow->addField(tr("Blendi&ng"), m_blending);
    blendRow->addField(tr("&Blend at border"), m_blend);
    body()->addWidget(blendRow);
    m_miss->setObjectName(QStringLiteral("photoMisses"));
    m_miss->setProperty("warning", true);
    m_miss->setWordWrap(true);
    body()->addWidget(m_miss);
    body()->addWidget(m_visible);
    body()->addWidget(m_occlusion);
}

void PhotoPanel::connectControls() {
    connect(m_opacity, &QSlider::valueChanged, this, [this](int percent) { setOpacity(percent / 100.0); });
    connect(m_opacity, &ValueSlider::gestureFinished, &m_document, &Document::finishGesture);
    connect(m_opacityField, &NumberField::valueEdited, this, [this](double opacity) { setOpacity(opacity); });
    for (NumberField* field : {m_opacityField, m_blend})
        connect(field, &NumberField::gestureFinished, &m_document, &Document::finishGesture);
    connect(m_blend, &NumberField::valueEdited, this, [this](double pixels) {
        edit(
            tr("Set blend at border"), [=](TextureLayer& layer) { layer.blendPixels = pixels; },
            EditKind::FadingBorder);
    });
    connect(m_blending, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        const Blending chosen = blendings.at(static_cast<std::size_t>(index));
        edit(tr("Set blending"), [=](TextureLayer& layer) { layer.blending = chosen; });
    });
    connect(m_visible, &QCheckBox::clicked, this, [this](bool on) {
        edit(on ? tr("Show layer") : tr("Hide layer"), [=](TextureLayer& layer) { layer.visible = on; });
    });
    connect(m_occlusion, &QCheckBox::clicked, this, [this](bool on) {
        edit(tr("Set what the projector reaches"),
             [=](TextureLayer& layer) { layer.projector.occlusion = on; });
    });
}

void PhotoPanel::show() {
    const TextureLayer* layer = m_selection.selectedLayer();
    showUse(layer);
    const QSignalBlocker quiet(m_opacity);
    m_opacityField->setValue(layer ? std::optional(layer->opacity) : std::nullopt);
    m_blend->setValue(layer ? std::optional(layer->blendPixels) : std::nullopt);
    m_opacity->setValue(layer ? qRound(layer->opacity * 100) : 0);
    m_opacity->setSpoken(tr("%1 %").arg(m_opacity->value()));
    m_blending->setCurrentIndex(layer ? static_cast<int>(layer->blending) : -1);
    m_visible->setChecked(layer && layer->visible);
    m_occlusion->setChecked(layer && layer->projector.occlusion);
    m_miss->setVisible(layer && missesOrgan(*layer));
}

bool PhotoPanel::missesOrgan(const TextureLayer& layer) const {
    const auto& mesh = m_document.project().mesh;
    return layer.photo && mesh && !mayMeet(layer.projector, sizeOf(*pictureOf(layer)), *mesh);
}

void PhotoPanel::showUse(const TextureLayer* layer) {
    const bool hasPhoto = layer && layer->photo;
    const QString why = tr("No layer is selected"),
                  noPhoto = layer ? tr("A painted layer has no photo") : why;
    const QString opacity = tr("How much of what lies beneath the layer hides");
    enable(m_visible, layer, tr("Whether the layer is part of the texture"), why);
    enable(m_occlusion, hasPhoto,
           tr("Leave out what faces away from the projector or lies behind other tissue"), noPhoto);
    enable(m_opacity, layer, opacity, why);
    enable(m_opacityField, layer, opacity, why);
    auto* entries = qobject_cast<QStandardItemModel*>(m_blending->model());
    entries->item(static_cast<int>(Blending::MultiBand))->setEnabled(hasPhoto); // paint has no bands
    enable(m_blending, layer,
           tr("normal hides what lies beneath, multiply darkens it, screen brightens it, overlay does both, "
              "colour leaves its brightness, seamless lets colours pass gradually into it"),
           why);
    enable(m_blend, hasPhoto,
           tr("Photo pixels over which the photo fades in from its border, from what is erased of it, "
              "and from outlines beyond which it does not see the surface"),
           noPhoto);
}

void PhotoPanel::setOpacity(double opacity) {
    edit(
        tr("Set opacity"), [=](TextureLayer& layer) { layer.opacity = opacity; }, EditKind::Opacity);
}

void PhotoPanel::edit(const QString& text, const std::function<void(TextureLayer&)>& change, EditKind kind) {
    const auto selected = m_selection.photo();
    if (!selected) return;
    m_document.edit(text, [&](Project& project) { change(partOf(project.layers, *selected)); },
                    {kind, *selected});
}

} // namespace esm
