#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "core/fuzzy/partition_edits.h"
#include "core/fuzzy/system_edits.h"

namespace esm {

/// Puts a changed fuzzy system in the place of the one a region has, and of every region's that has one like
/// it: they speak the same language. Values of renamed inputs follow their names; what an input that is gone
/// was set to goes with it, a new one starts in the middle of its range. Precondition: the region has a
/// system.
/// @throws InvalidModel with every problem of the system; the one before then stays in force
void editSystem(Project& project, RegionId region, const FuzzySystem& system);

/// Where a variable's values lie, and how its terms take it.
struct NewRange {
    double minimum, maximum;
    TermsInRange terms;
};

/// Another range for a variable of a region's system, as editSystem() does it. Where terms stretch along,
/// what an input is set to does too: it stays the same word.
void setRange(Project& project, RegionId region, const VariablePlace& place, const NewRange& range);

/// The fuzzy system of the selected region; null where there is none.
std::shared_ptr<const FuzzySystem> selectedSystem(const Selection& selection);

/// The same as an undoable edit of the selected region's system. Edits of one kind that follow each other
/// become one step. Precondition: it has one.
/// @throws InvalidModel with every problem of the system; the document then stays as it was
void editSelectedSystem(Document& document, const Selection& selection, const QString& text,
                        const FuzzySystem& system, EditKind kind = EditKind::Alone);

} // namespace esm
