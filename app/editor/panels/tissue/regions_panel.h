#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/panels/layers_panel.h"
#include "app/editor/panels/tissue/region_counts.h"

namespace esm {

/// The organ's regions, the topmost first and the whole organ at the bottom.
class RegionsPanel : public LayersPanel {
    Q_OBJECT

public:
    RegionsPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

protected:
    void show() override;
    std::size_t layerCount() const override { return m_document.project().regions.size(); }
    std::optional<std::size_t> selectedLayer() const override;
    void selectLayer(std::optional<std::size_t> layer) override;
    bool canMoveLayer(std::size_t layer, int above) const override;
    void moveLayer(std::size_t layer, int above) override;
    void removeLayer(std::size_t layer) override;
    void renameLayer(std::size_t layer, const std::string& name) override;

private:
    Obstacles obstacles() const;
    RegionId regionAt(std::size_t layer) const { return m_document.project().regions[layer].id; }

    Document& m_document;
    Selection& m_selection;
    RegionCounts m_counts;
};

} // namespace esm
