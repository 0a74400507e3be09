#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"

#include <QToolButton>

namespace esm {

/// A menu of the tissues that ship with the program. The chosen one is for what is selected: the whole organ,
/// with mass and tethers, or one region's words.
class TissuePresetButton : public QToolButton {
    Q_OBJECT

public:
    TissuePresetButton(Document& document, Selection& selection, QWidget* parent = nullptr);

private:
    bool isPartSelected() const;
    void fill();
    void apply(const std::string& presetName);

    Document& m_document;
    Selection& m_selection;
};

} // namespace esm
