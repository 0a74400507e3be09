#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"
#include "widgets/inputs/value_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>

#include <functional>

namespace esm {

/// How the selected layer shines, or the organ where no layer says it.
class WetLookPanel : public Section {
    Q_OBJECT

public:
    WetLookPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

private:
    /// A part of 1, by a number and by a slider.
    struct Share {
        NumberField* field;
        ValueSlider* slider;
        QString edit; ///< what the step is called
        std::function<double&(LayerFinish&)> part;
    };

    void addShare(const QString& caption, const QString& name, const QString& edit,
                  std::function<double&(LayerFinish&)> part);
    void connectControls();
    void connectShare(std::size_t place);
    void takeSelection();
    void show();
    void showUse(const std::optional<LayerFinish>& finish);
    void choose(int tissue);
    void setRelief(double metres);
    void setOcclusion(double reach);
    void showWarnings();
    /// Changes what the panel speaks of, which then has a finish. @param place tells the panel's numbers
    /// apart
    void change(const QString& text, const std::function<void(LayerFinish&)>& to,
                EditKind kind = EditKind::Alone, std::uint64_t place = 0);
    void put(const QString& text, const std::optional<LayerFinish>& finish, MergeKey key);
    bool isOfLayer() const;
    /// Of what the panel speaks of; of the organ only the surface means something.
    std::optional<LayerFinish> finish() const;

    Document& m_document;
    Selection& m_selection;
    QComboBox *m_subject, *m_tissue;
    std::vector<Share> m_shares; ///< roughness, wetness, wetness at highlights
    NumberField *m_relief, *m_occlusion;
    QCheckBox* m_hidesColour;
    QLabel* m_warnings;
};

} // namespace esm
