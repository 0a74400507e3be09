#pragma once

#include "app/editor/document/document.h"
#include "core/authoring/systems.h"

#include <QToolButton>

namespace esm {

/// A menu of the project's own fuzzy systems, in which those can be removed that no region uses. Of those
/// that ship with the program none is there: they are always at hand.
class SpareSystemsButton : public QToolButton {
    Q_OBJECT

public:
    explicit SpareSystemsButton(Document& document, QWidget* parent = nullptr);

private:
    void fill();
    void addSystem(const SharedSystem& system);

    Document& m_document;
};

} // namespace esm
