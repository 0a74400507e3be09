#include "app/editor/panels/texture/photos_panel.h"

#include "app/editor/edits/layer_edits.h"
#include "app/editor/panels/texture/photo_panel.h"
#include "core/authoring/layers.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/icon.h"
#include "widgets/texture/image_conversion.h"

namespace esm {

PhotosPanel::PhotosPanel(Document& document, Selection& selection, QWidget* parent)
    : LayersPanel(tr("Photos"), QPalette::LinkVisited,
                  {tr("Lay over the photo above (Ctrl+Up)"), tr("Lay under the photo below (Ctrl+Down)"),
                   tr("Remove the photo (Del)")},
                  parent),
      m_document(document), m_selection(selection),
      m_paint(addHeaderIcon(icon(QStringLiteral("brush")), tr("Add paint layer"))) {
    list()->setObjectName(QStringLiteral("photoList"));
    list()->setEmptyText(tr("No photo yet. Add one, or drop a picture on the organ."));
    connect(list(), &ItemList::eyeClicked, this, &PhotosPanel::showOrHide);
    connect(&selection, &Selection::changed, this, &PhotosPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.layers) show();
    });
    PhotosPanel::show();
}

void PhotosPanel::setPaintAction(QAction* action) {
    follow(m_paint, action);
}

QPixmap PhotosPanel::picture(const std::shared_ptr<const Photo>& photo) {
    QPixmap& known = m_pictures[photo];
    if (known.isNull()) known = QPixmap::fromImage(thumbnail(photo->image, 84));
    return known;
}

namespace {

/// How it blends, where it does not just hide what lies beneath, and how much of it is seen.
QString noteOf(const TextureLayer& layer) {
    if (!layer.visible) return PhotosPanel::tr("hidden");
    QString opacity = PhotosPanel::tr("%1 %").arg(qRound(layer.opacity * 100));
    if (layer.blending == Blending::Normal) return opacity;
    return PhotosPanel::tr("%1, %2").arg(blendingText(layer.blending), opacity);
}

/// The first colour that is painted on a layer without photo.
QPixmap painted(const TextureLayer& layer) {
    Image swatch{1, 1, {128, 128, 128, 255}};
    for (auto stroke = layer.strokes.rbegin(); stroke != layer.strokes.rend(); ++stroke)
        if ((*stroke)->kind == BrushKind::Colour)
            std::copy((*stroke)->colour.begin(), (*stroke)->colour.end(), swatch.pixels.begin());
    return QPixmap::fromImage(thumbnail(swatch, 84));
}

} // namespace

void PhotosPanel::show() {
    const Project& project = m_document.project();
    std::vector<ItemRow> rows;
    std::map<std::shared_ptr<const Photo>, QPixmap> inUse;
    for (std::size_t i = project.layers.size(); i-- > 0;) {
        const TextureLayer& layer = project.layers[i];
        const QString note = noteOf(layer);
        if (layer.photo) inUse[layer.photo] = picture(layer.photo);
        rows.push_back({QString::fromStdString(layer.name),
                        note,
                        {},
                        layer.photo ? inUse[layer.photo] : painted(layer),
                        true,
                        layer.visible});
    }
    m_pictures = std::move(inUse);
    const auto selected = selectedLayer();
    list()->setRows(rows, selected ? rowOf(*selected) : -1);
    showButtons(obstacles());
}

void PhotosPanel::showOrHide(int row) {
    if (const auto layer = layerOf(row)) esm::showOrHide(m_document, layerAt(*layer));
}

LayersPanel::Obstacles PhotosPanel::obstacles() const {
    const auto selected = selectedLayer();
    const QString none = tr("No photo is selected");
    if (!selected) return {none, none, none};
    return {canMoveLayer(*selected, 1) ? QString() : tr("This photo already lies on top"),
            canMoveLayer(*selected, -1) ? QString() : tr("This photo already lies at the bottom"),
            {}};
}

std::optional<std::size_t> PhotosPanel::selectedLayer() const {
    const auto layer = m_selection.photo();
    return layer ? placeOf(m_document.project().layers, *layer) : std::nullopt;
}

void PhotosPanel::selectLayer(std::optional<std::size_t> layer) {
    m_selection.setPhoto(layer ? std::optional(layerAt(*layer)) : std::nullopt);
}

bool PhotosPanel::canMoveLayer(std::size_t layer, int above) const {
    return esm::canMoveLayer(m_document.project(), layerAt(layer), above);
}

void PhotosPanel::moveLayer(std::size_t layer, int above) {
    m_document.edit(tr("Reorder photos"),
                    [id = layerAt(layer), above](Project& project) { esm::moveLayer(project, id, above); });
}

void PhotosPanel::removeLayer(std::size_t layer) {
    m_document.edit(tr("Remove photo"),
                    [id = layerAt(layer)](Project& project) { esm::removeLayer(project, id); });
}

void PhotosPanel::renameLayer(std::size_t layer, const std::string& name) {
    m_document.edit(tr("Rename photo"), [&](Project& project) { project.layers[layer].name = name; });
}

} // namespace esm
