#pragma once

#include "app/editor/document/document.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

namespace esm {

/// What the organ is: counts, size, place, mass [R 2.3.7].
class ModelPanel : public Section {
    Q_OBJECT

public:
    explicit ModelPanel(Document& document, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void show(const Change& change);
    void showMesh();
    /// What takes an evaluation of the model: only while it is seen.
    void showEvaluated();

    Document& m_document;
    QLabel *m_nodes, *m_springs, *m_vertices, *m_size, *m_centre, *m_fixed, *m_totalMass, *m_fixing;
    NumberField* m_baseMass;
    bool m_evaluated = false;
};

} // namespace esm
