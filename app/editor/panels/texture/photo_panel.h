#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"
#include "widgets/inputs/value_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>

namespace esm {

/// As the window names it.
QString blendingText(Blending blending);

/// The selected photo as a layer: how strongly and where it shows.
class PhotoPanel : public Section {
    Q_OBJECT

public:
    PhotoPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

private:
    void layOut();
    void connectControls();
    void show();
    void showUse(const TextureLayer* layer);
    bool missesOrgan(const TextureLayer& layer) const;
    void setOpacity(double opacity);
    void edit(const QString& text, const std::function<void(TextureLayer&)>& change,
              EditKind kind = EditKind::Alone);

    Document& m_document;
    Selection& m_selection;
    QCheckBox *m_visible, *m_occlusion;
    ValueSlider* m_opacity;
    NumberField* m_opacityField;
    QComboBox* m_blending;
    NumberField* m_blend;
    QLabel* m_miss;
};

} // namespace esm
