#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "core/authoring/edit_system.h"

namespace esm {

/// The fuzzy system of the selected region; null where there is none.
std::shared_ptr<const FuzzySystem> selectedSystem(const Selection& selection);

/// So far, and no copy takes the name of a system that ships.
EditScope scopeOf(Reach reach);

/// What is edited, and how the edit is called.
struct SystemStep {
    QString text;
    EditKind kind = EditKind::Alone;
    Reach reach = Reach::EveryRegion;
};

/// editSystem() as an undoable edit of the selected region's system. Edits of one kind that follow each other
/// become one step. Precondition: it has one.
/// @throws InvalidModel with every problem of the system; the document then stays as it was
void editSelectedSystem(Document& document, const Selection& selection, const FuzzySystem& system,
                        const SystemStep& step);

} // namespace esm
