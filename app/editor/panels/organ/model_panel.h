#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/preview.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

namespace esm {

/// What the organ is: counts, size, place, mass [R 2.3.7].
class ModelPanel : public Section {
    Q_OBJECT

public:
    ModelPanel(Document& document, Preview& preview, QWidget* parent = nullptr);

private:
    void show(const Change& change);
    void showMesh();
    /// What takes an evaluation of the model, which the preview makes; until it has, what was there stays.
    void showTissue();

    Document& m_document;
    Preview& m_preview;
    QLabel *m_nodes, *m_springs, *m_vertices, *m_inside, *m_size, *m_centre, *m_fixed, *m_totalMass,
        *m_fixing;
    NumberField* m_baseMass;
};

} // namespace esm
