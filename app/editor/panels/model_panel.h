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

private:
    void show(const Change& change);
    void showMesh();

    Document& m_document;
    QLabel *m_nodes, *m_springs, *m_size, *m_centre, *m_fixed;
    NumberField* m_mass;
};

} // namespace esm
