#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/edits/system_reach.h"
#include "core/fuzzy/partition_edits.h"
#include "core/fuzzy/system_edits.h"

namespace esm {

/// Puts a changed fuzzy system in the place of the one a region has. It reaches every region that has one
/// like it, since they speak the same language, or becomes a copy with a name of its own that this region
/// alone gets. Values of renamed inputs follow their names; what an input that is gone was set to goes with
/// it, a new one starts in the middle of its range. Precondition: the region has a system.
/// @throws InvalidModel with every problem of the system; the one before then stays in force
void editSystem(Project& project, RegionId region, const FuzzySystem& system,
                Reach reach = Reach::EveryRegion);

/// Where a variable's values lie, and how its terms take it.
struct NewRange {
    double minimum, maximum;
    TermsInRange terms;
};

/// Another range for a variable of a region's system, as editSystem() does it. Where terms stretch along,
/// what an input is set to does too: it stays the same word.
void setRange(Project& project, RegionId region, const VariablePlace& place, const NewRange& range,
              Reach reach = Reach::EveryRegion);

/// The fuzzy system of the selected region; null where there is none.
std::shared_ptr<const FuzzySystem> selectedSystem(const Selection& selection);

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
