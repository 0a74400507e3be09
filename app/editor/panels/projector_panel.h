#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/inputs/section.h"
#include "widgets/inputs/vector_field.h"

#include <QPushButton>

namespace esm {

/// Where the selected photo's projector stands, in numbers.
class ProjectorPanel : public Section {
    Q_OBJECT

public:
    ProjectorPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    /// What the button "From camera" does.
    void setFromCameraAction(QAction* action);

private:
    void show();
    /// @param mergeKey of edits that become one step while a gesture lasts
    void edit(const QString& text, const std::function<void(Projector&)>& change, const QString& mergeKey);

    Document& m_document;
    Selection& m_selection;
    NumberField *m_width, *m_height;
    VectorField *m_position, *m_turned;
    QPushButton* m_fromCamera;
};

} // namespace esm
