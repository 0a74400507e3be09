#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/panels/tissue/region_counts.h"
#include "widgets/inputs/section.h"
#include "widgets/inputs/vector_field.h"

namespace esm {

/// The selected region's ellipsoid in numbers.
class EllipsoidPanel : public Section {
    Q_OBJECT

public:
    EllipsoidPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void show();
    /// Counting takes a moment: only while it is seen.
    void showInside();
    void edit(const QString& text, const std::function<void(Ellipsoid&)>& change, EditKind kind);
    void editRim(double metres);

    Document& m_document;
    Selection& m_selection;
    VectorField *m_centre, *m_radii, *m_turned;
    NumberField* m_rim;
    QLabel *m_nodesInside, *m_springsInside;
    RegionCounts m_counts;
};

} // namespace esm
