#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/panels/layers_panel.h"

#include <map>

namespace esm {

/// The photos on the organ, the topmost first.
class PhotosPanel : public LayersPanel {
    Q_OBJECT

public:
    PhotosPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    /// What the button with the brush does.
    void setPaintAction(QAction* action);

protected:
    void show() override;
    std::size_t layerCount() const override { return m_document.project().layers.size(); }
    std::optional<std::size_t> selectedLayer() const override;
    void selectLayer(std::optional<std::size_t> layer) override;
    bool canMoveLayer(std::size_t layer, int above) const override;
    void moveLayer(std::size_t layer, int above) override;
    void removeLayer(std::size_t layer) override;
    void renameLayer(std::size_t layer, const std::string& name) override;

private:
    void showOrHide(int row);
    Obstacles obstacles() const;
    LayerId layerAt(std::size_t layer) const { return m_document.project().layers[layer].id; }
    QPixmap picture(const std::shared_ptr<const Photo>& photo);

    Document& m_document;
    Selection& m_selection;
    QToolButton* m_paint;
    std::map<std::shared_ptr<const Photo>, QPixmap> m_pictures; ///< made once per photo
};

} // namespace esm
