#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/inputs/item_list.h"
#include "widgets/inputs/section.h"

#include <map>

namespace esm {

/// The photos on the organ, the topmost first.
class PhotosPanel : public Section {
    Q_OBJECT

public:
    PhotosPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

signals:
    void addRequested();

private:
    void show();
    void move(int above);
    void removeSelected();
    void rename(int row, const QString& name);
    std::optional<std::size_t> photoOfRow(int row) const;
    QPixmap picture(const std::shared_ptr<const Photo>& photo);

    Document& m_document;
    Selection& m_selection;
    ItemList* m_list;
    QToolButton *m_up, *m_down, *m_remove;
    std::map<std::shared_ptr<const Photo>, QPixmap> m_pictures; ///< made once per photo
};

} // namespace esm
