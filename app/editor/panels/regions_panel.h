#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/inputs/item_list.h"
#include "widgets/inputs/section.h"

namespace esm {

/// The organ's regions, the topmost first and the whole organ at the bottom.
class RegionsPanel : public Section {
    Q_OBJECT

public:
    RegionsPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    /// Adds an ellipsoid in the organ's middle.
    void addRegion();
    void removeSelected();

private:
    void show();
    void showButtons();
    void move(int above);
    void rename(int row, const QString& name);
    std::optional<std::size_t> regionOfRow(int row) const;

    Document& m_document;
    Selection& m_selection;
    ItemList* m_list;
    QToolButton *m_up, *m_down, *m_remove;
};

} // namespace esm
