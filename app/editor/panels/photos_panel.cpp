#include "app/editor/panels/photos_panel.h"

#include "app/editor/commands/photo_edits.h"
#include "widgets/inputs/icon.h"
#include "widgets/texture/image_conversion.h"

namespace esm {

PhotosPanel::PhotosPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Photos"), parent), m_document(document), m_selection(selection),
      m_list(new ItemList(QPalette::LinkVisited, this)) {
    m_up = addHeaderIcon(icon(QStringLiteral("up")), tr("Lay over the photo above"));
    m_down = addHeaderIcon(icon(QStringLiteral("down")), tr("Lay under the photo below"));
    m_remove = addHeaderIcon(icon(QStringLiteral("remove")), tr("Remove the photo (Del)"));
    QToolButton* add = addHeaderButton(tr("+ add"), tr("Add a photo, seen from the camera (Ctrl+P)"));
    m_list->setObjectName(QStringLiteral("photoList"));
    m_list->setAccessibleName(tr("Photos"));
    m_list->setEmptyText(tr("No photo yet. Add one, or drop a picture on the organ."));
    body()->addWidget(m_list);

    connect(add, &QToolButton::clicked, this, &PhotosPanel::addRequested);
    connect(m_up, &QToolButton::clicked, this, [this] { move(1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_remove, &QToolButton::clicked, this, &PhotosPanel::removeSelected);
    connect(m_list, &ItemList::removeRequested, this, &PhotosPanel::removeSelected);
    connect(m_list, &ItemList::rowRenamed, this, &PhotosPanel::rename);
    connect(m_list, &ItemList::rowSelected, this, [this](int row) { m_selection.setPhoto(photoOfRow(row)); });
    connect(&selection, &Selection::changed, this, &PhotosPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.photos) show();
    });
    show();
}

std::optional<std::size_t> PhotosPanel::photoOfRow(int row) const {
    const std::size_t count = m_document.project().photos.size();
    if (row < 0 || static_cast<std::size_t>(row) >= count) return std::nullopt;
    return count - 1 - static_cast<std::size_t>(row);
}

QPixmap PhotosPanel::picture(const std::shared_ptr<const Photo>& photo) {
    QPixmap& known = m_pictures[photo];
    if (known.isNull()) known = QPixmap::fromImage(thumbnail(photo->image, 84));
    return known;
}

void PhotosPanel::show() {
    const Project& project = m_document.project();
    std::vector<ItemRow> rows;
    std::map<std::shared_ptr<const Photo>, QPixmap> inUse;
    for (std::size_t i = project.photos.size(); i-- > 0;) {
        const PhotoLayer& layer = project.photos[i];
        const QString note = layer.visible ? tr("%1 %").arg(qRound(layer.opacity * 100)) : tr("hidden");
        inUse[layer.photo] = picture(layer.photo);
        rows.push_back({QString::fromStdString(layer.name), note, {}, inUse[layer.photo], true});
    }
    m_pictures = std::move(inUse);
    const auto selected = m_selection.photo();
    m_list->setRows(rows, selected ? static_cast<int>(rows.size() - 1 - *selected) : -1);

    const auto enable = [](QToolButton* button, bool on, const QString& does, const QString& why) {
        button->setEnabled(on);
        button->setToolTip(on ? does : why);
    };
    const QString none = tr("No photo is selected");
    enable(m_up, selected && canMovePhoto(project, *selected, 1), tr("Lay over the photo above"),
           selected ? tr("This photo already lies on top") : none);
    enable(m_down, selected && canMovePhoto(project, *selected, -1), tr("Lay under the photo below"),
           selected ? tr("This photo already lies at the bottom") : none);
    enable(m_remove, selected.has_value(), tr("Remove the photo (Del)"), none);
}

void PhotosPanel::move(int above) {
    const auto selected = m_selection.photo();
    if (!selected || !canMovePhoto(m_document.project(), *selected, above)) return;
    m_document.edit(tr("Reorder photos"), [=](Project& project) { movePhoto(project, *selected, above); });
    m_selection.setPhoto(above > 0 ? *selected + 1 : *selected - 1);
}

void PhotosPanel::removeSelected() {
    const auto selected = m_selection.photo();
    if (!selected) return;
    m_document.edit(tr("Remove photo"), [selected](Project& project) {
        project.photos.erase(project.photos.begin() + static_cast<std::ptrdiff_t>(*selected));
    });
}

void PhotosPanel::rename(int row, const QString& name) {
    const auto photo = photoOfRow(row);
    if (photo && !name.isEmpty())
        m_document.edit(tr("Rename photo"),
                        [&](Project& project) { project.photos[*photo].name = name.toStdString(); });
    // An empty name was not taken: the old one comes back.
    QMetaObject::invokeMethod(this, &PhotosPanel::show, Qt::QueuedConnection);
}

} // namespace esm
