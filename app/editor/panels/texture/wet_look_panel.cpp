#include "app/editor/panels/texture/wet_look_panel.h"

#include "app/editor/dialogs/sentence.h"
#include "core/texture/maps/finish_layers.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quantity_formats.h"

#include <QSignalBlocker>
#include <QStandardItemModel>

#include <algorithm>

namespace esm {

namespace {

enum Subject { SelectedLayer, WholeOrgan };

// Entries of the tissue; behind the presets stands one for other numbers.
constexpr int noFinish = 0, firstPreset = 1,
              ownNumbers = firstPreset + static_cast<int>(finishPresets.size());

constexpr std::size_t highlightsPlace = 2;

NumberFormat reliefFormat() {
    NumberFormat format = lengthFormat(0);
    format.decimals = -1; // fine ones are thousandths of a millimetre
    format.maximum = deepestRelief;
    format.step = 0.00005;
    return format;
}

NumberFormat occlusionFormat() {
    NumberFormat format = lengthFormat(0);
    format.maximum = farthestOcclusion;
    format.step = 0.001;
    return format;
}

/// The entry that says a finish.
int tissueOf(const std::optional<LayerFinish>& finish) {
    if (!finish) return noFinish;
    const auto preset =
        std::find_if(finishPresets.begin(), finishPresets.end(),
                     [&](const FinishPreset& known) { return known.surface == finish->surface; });
    return firstPreset + static_cast<int>(preset - finishPresets.begin());
}

} // namespace

WetLookPanel::WetLookPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Wet look"), parent), m_document(document), m_selection(selection),
      m_subject(new QComboBox(this)), m_tissue(new QComboBox(this)),
      m_relief(new NumberField(reliefFormat(), this)), m_occlusion(new NumberField(occlusionFormat(), this)),
      m_hidesColour(new QCheckBox(tr("Hide the layer's colour"), this)), m_warnings(new QLabel(this)) {
    m_subject->setObjectName(QStringLiteral("wetLookSubject"));
    m_subject->addItems({tr("selected layer"), tr("whole organ")});
    m_tissue->setObjectName(QStringLiteral("wetLookTissue"));
    m_tissue->addItem(tr("none"));
    for (const FinishPreset& preset : finishPresets)
        m_tissue->addItem(tr(preset.name).toLower());
    m_tissue->addItem(tr("own numbers")); // says what is, and is not chosen
    qobject_cast<QStandardItemModel*>(m_tissue->model())->item(ownNumbers)->setEnabled(false);
    for (QComboBox* choice : {m_subject, m_tissue})
        guardFromWheel(*choice);
    auto* rows = new ValueRows(this);
    rows->addField(tr("Wet look of"), m_subject);
    rows->addField(tr("Tissue"), m_tissue);
    body()->addWidget(rows);
    addShare(tr("Roughness"), QStringLiteral("wetLookRoughness"), tr("Set roughness"),
             [](LayerFinish& finish) -> double& { return finish.surface.roughness; });
    addShare(tr("Wetness"), QStringLiteral("wetLookWetness"), tr("Set wetness"),
             [](LayerFinish& finish) -> double& { return finish.surface.wetness; });
    addShare(tr("Wet at highlights"), QStringLiteral("wetLookAtHighlights"), tr("Set wetness at highlights"),
             [](LayerFinish& finish) -> double& { return finish.wetAtHighlights; });
    m_relief->setObjectName(QStringLiteral("wetLookRelief"));
    auto* reliefRow = new ValueRows(this);
    reliefRow->addField(tr("Relief"), m_relief);
    body()->addWidget(reliefRow);
    m_warnings->setObjectName(QStringLiteral("wetLookWarnings"));
    m_warnings->setProperty("warning", true);
    m_warnings->setWordWrap(true);
    body()->addWidget(m_warnings);
    body()->addWidget(m_hidesColour);
    m_occlusion->setObjectName(QStringLiteral("wetLookOcclusion"));
    auto* occlusionRow = new ValueRows(this);
    occlusionRow->addField(tr("Baked occlusion"), m_occlusion);
    body()->addWidget(occlusionRow);
    connectControls();
    takeSelection();
}

void WetLookPanel::addShare(const QString& caption, const QString& name, const QString& edit,
                            std::function<double&(LayerFinish&)> part) {
    const Share share{new NumberField(shareFormat(), this), new ValueSlider(this), edit, std::move(part)};
    share.field->setObjectName(name);
    share.slider->setObjectName(name + QStringLiteral("Slider"));
    share.slider->setAccessibleName(caption);
    share.slider->setRange(0, 100);
    share.slider->setScale(0, 100);
    auto* row = new ValueRows(this);
    row->addField(caption, share.field);
    body()->addWidget(row);
    body()->addWidget(share.slider);
    m_shares.push_back(share);
}

void WetLookPanel::connectControls() {
    for (std::size_t place = 0; place < m_shares.size(); ++place)
        connectShare(place);
    connect(m_subject, qOverload<int>(&QComboBox::activated), this, &WetLookPanel::show);
    connect(m_tissue, qOverload<int>(&QComboBox::activated), this, &WetLookPanel::choose);
    connect(m_relief, &NumberField::valueEdited, this, &WetLookPanel::setRelief);
    connect(m_relief, &NumberField::gestureFinished, &m_document, &Document::finishGesture);
    connect(m_occlusion, &NumberField::valueEdited, this, &WetLookPanel::setOcclusion);
    connect(m_occlusion, &NumberField::gestureFinished, &m_document, &Document::finishGesture);
    connect(m_hidesColour, &QCheckBox::clicked, this, [this](bool on) {
        change(on ? tr("Hide the layer's colour") : tr("Show the layer's colour"),
               [=](LayerFinish& finish) { finish.hidesColour = on; });
    });
    connect(&m_selection, &Selection::changed, this, &WetLookPanel::takeSelection);
    connect(&m_document, &Document::changed, this, [this](const Change& changed) {
        if (changed.layers || changed.texture) show();
    });
}

void WetLookPanel::connectShare(std::size_t place) {
    const Share& share = m_shares[place];
    const auto set = [this, place](double value) {
        const Share& edited = m_shares[place];
        change(
            edited.edit, [&](LayerFinish& finish) { edited.part(finish) = value; }, EditKind::Finish, place);
    };
    connect(share.field, &NumberField::valueEdited, this, set);
    connect(share.slider, &QSlider::valueChanged, this, [set](int percent) { set(percent / 100.0); });
    connect(share.field, &NumberField::gestureFinished, &m_document, &Document::finishGesture);
    connect(share.slider, &ValueSlider::gestureFinished, &m_document, &Document::finishGesture);
}

void WetLookPanel::takeSelection() {
    m_subject->setCurrentIndex(m_selection.selectedLayer() ? SelectedLayer : WholeOrgan);
    show();
}

void WetLookPanel::show() {
    const auto shown = finish();
    LayerFinish parts = shown.value_or(LayerFinish());
    m_tissue->setCurrentIndex(tissueOf(shown));
    m_tissue->setItemText(noFinish, isOfLayer() ? tr("as the layers beneath") : tr("none"));
    for (const Share& share : m_shares) {
        const QSignalBlocker quiet(share.slider);
        const double part = share.part(parts);
        share.field->setValue(shown ? std::optional(part) : std::nullopt);
        share.slider->setValue(shown ? qRound(100 * part) : 0);
        share.slider->setSpoken(tr("%1 %").arg(share.slider->value()));
    }
    m_relief->setValue(shown ? std::optional(parts.relief) : std::nullopt);
    m_hidesColour->setChecked(parts.hidesColour);
    m_occlusion->setValue(isOfLayer() ? std::nullopt
                                      : std::optional(m_document.project().texture.occlusionReach));
    showUse(shown);
    showWarnings();
}

void WetLookPanel::showWarnings() {
    const TextureLayer* layer = isOfLayer() ? m_selection.selectedLayer() : nullptr;
    QStringList warnings;
    if (layer && layer->finish && layer->finish->relief > 0)
        for (const std::string& warning : finishWarnings(*layer))
            warnings.append(sentence(warning));
    if (layer && layer->finish && !m_document.project().texture.finish)
        warnings.append(tr("The rest of the organ is shown dry beside it: choose its tissue as well, under "
                           "whole organ."));
    m_warnings->setText(warnings.join('\n'));
    m_warnings->setVisible(!warnings.isEmpty());
}

void WetLookPanel::showUse(const std::optional<LayerFinish>& finish) {
    const bool hasSurface = !m_document.project().mesh->triangles.empty();
    const bool hasSubject = hasSurface && (m_subject->currentIndex() == WholeOrgan || isOfLayer());
    const TextureLayer* layer = isOfLayer() ? m_selection.selectedLayer() : nullptr;
    const bool hasPhoto = finish && layer && layer->photo;
    const QString none = hasSurface ? tr("No layer is selected") : tr("This model has no surface");
    const QString why = hasSubject ? tr("Choose a tissue first") : none;
    const QString noPhoto = finish ? tr("Comes from a layer's photo") : why;
    m_subject->setToolTip(tr("A layer lends its wet look to what it covers; elsewhere the organ's shows"));
    enable(m_tissue, hasSubject, tr("Roughness and wetness of such tissue, estimated by eye"), none);
    const std::array<QString, 3> uses{tr("Of the tissue beneath the fluid: 0 mirrors, 100 % is dull"),
                                      tr("How much of the surface a film of fluid covers"),
                                      tr("How much wetter it is where the photo mirrors the lamp")};
    for (std::size_t place = 0; place < m_shares.size(); ++place) {
        const bool isOfPhoto = place == highlightsPlace;
        for (QWidget* control :
             std::initializer_list<QWidget*>{m_shares[place].field, m_shares[place].slider})
            enable(control, isOfPhoto ? hasPhoto : finish.has_value(), uses.at(place),
                   isOfPhoto ? noPhoto : why);
    }
    enable(m_relief, hasPhoto,
           tr("How high a spot stands that is half as bright again as its surroundings in the photo. That "
              "bright "
              "is high is a guess: a photo does not tell form from colour"),
           noPhoto);
    enable(m_hidesColour, finish && layer,
           tr("The layer shows nothing but its wet look, as where wet or charred spots are painted"),
           layer ? why : tr("Of a layer only"));
    enable(m_occlusion, hasSurface && m_subject->currentIndex() == WholeOrgan,
           tr("Packages and baked pages get a picture of how folds darken, by what stands within this "
              "distance; 0 for none. It is not shown here"),
           hasSurface ? tr("Of the whole organ: choose it under Wet look of") : none);
}

void WetLookPanel::choose(int tissue) {
    if (tissue == noFinish) return put(tr("Remove wet look"), std::nullopt, {});
    const SurfaceFinish& chosen = finishPresets.at(static_cast<std::size_t>(tissue - firstPreset)).surface;
    change(tr("Set wet look"), [&](LayerFinish& finish) { finish.surface = chosen; });
}

void WetLookPanel::setRelief(double metres) {
    change(
        tr("Set relief"), [=](LayerFinish& finish) { finish.relief = metres; }, EditKind::Finish,
        m_shares.size());
}

void WetLookPanel::setOcclusion(double reach) {
    m_document.edit(
        tr("Set occlusion"), [=](Project& project) { project.texture.occlusionReach = reach; },
        MergeKey{EditKind::Finish, m_shares.size() + 1});
}

bool WetLookPanel::isOfLayer() const {
    return m_subject->currentIndex() == SelectedLayer && m_selection.selectedLayer();
}

std::optional<LayerFinish> WetLookPanel::finish() const {
    if (isOfLayer()) return m_selection.selectedLayer()->finish;
    const auto& organ = m_document.project().texture.finish;
    if (m_subject->currentIndex() == SelectedLayer || !organ) return std::nullopt;
    return LayerFinish{*organ};
}

void WetLookPanel::change(const QString& text, const std::function<void(LayerFinish&)>& to, EditKind kind,
                          std::uint64_t place) {
    LayerFinish changed = finish().value_or(LayerFinish());
    to(changed);
    put(text, changed, isOfLayer() ? MergeKey{kind, *m_selection.photo(), place} : MergeKey{kind, place});
}

void WetLookPanel::put(const QString& text, const std::optional<LayerFinish>& finish, MergeKey key) {
    const auto layer = isOfLayer() ? m_selection.photo() : std::nullopt;
    m_document.edit(
        text,
        [&](Project& project) {
            if (layer)
                partOf(project.layers, *layer).finish = finish;
            else
                project.texture.finish = finish ? std::optional(finish->surface) : std::nullopt;
        },
        key);
}

} // namespace esm
