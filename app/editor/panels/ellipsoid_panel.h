#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/inputs/section.h"
#include "widgets/inputs/vector_field.h"

namespace esm {

/// The selected region's ellipsoid in numbers.
class EllipsoidPanel : public Section {
    Q_OBJECT

public:
    EllipsoidPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

private:
    void show();
    void edit(const QString& text, const std::function<void(Ellipsoid&)>& change);

    Document& m_document;
    Selection& m_selection;
    VectorField *m_centre, *m_radii, *m_turned;
    QLabel* m_inside;
};

} // namespace esm
