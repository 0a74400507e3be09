#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/inputs/section.h"
#include "widgets/inputs/vector_field.h"

#include <QComboBox>
#include <QPushButton>

#include <array>

namespace esm {

/// Where the selected photo's projector stands, in numbers.
class ProjectorPanel : public Section {
    Q_OBJECT

public:
    ProjectorPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    /// What the button "From camera" does.
    void setFromCameraAction(QAction* action);
    /// What the button "Look through" does.
    void setLookThroughAction(QAction* action);

private:
    void layOut();
    void layOutSize();
    void connectFields();
    void connectIntrinsics();
    void show();
    void showKind(const Projector* projector);
    void showCamera(const Projector* projector);
    void chooseKind();
    void resize(double Projector::*edited, double Projector::*other, double metres);
    Intrinsics shownIntrinsics() const;
    void edit(const QString& text, const std::function<void(Projector&)>& change, EditKind kind,
              std::uint64_t place = 0);

    Document& m_document;
    Selection& m_selection;
    QComboBox* m_kind;
    NumberField *m_width, *m_height, *m_fieldOfView;
    QToolButton* m_keepProportions;
    std::array<NumberField*, 4> m_intrinsics; ///< focal lengths, then the principal point
    ValueRows *m_sizeRows, *m_perspectiveRows, *m_measuredRows;
    QWidget* m_size; ///< of a parallel projector
    VectorField *m_position, *m_turned;
    QPushButton *m_fromCamera, *m_lookThrough;
};

} // namespace esm
