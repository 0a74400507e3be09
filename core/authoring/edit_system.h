#pragma once

#include "core/fuzzy/partition_edits.h"
#include "core/fuzzy/system_edits.h"
#include "core/project/project.h"

#include <string>
#include <vector>

namespace esm {

/// What an edit of a fuzzy system changes: the system of every region that uses it, or a copy that the
/// edited region gets.
enum class Reach { EveryRegion, CopyForOne };

struct EditScope {
    Reach reach = Reach::EveryRegion;
    /// No copy is called so, nor like a system of the project.
    std::vector<std::string> takenNames{};
};

/// Puts a changed fuzzy system in the place of the one a region has. It reaches every region that has one
/// like it, since they speak the same language, or becomes a copy with a name of its own that this region
/// alone gets. Values of renamed inputs follow their names; what an input that is gone was set to goes with
/// it, a new one starts in the middle of its range. Precondition: the region has a system.
/// @throws InvalidModel with every problem of the system; the one before then stays in force
void editSystem(Project& project, RegionId region, const FuzzySystem& system, const EditScope& scope = {});

/// Where a variable's values lie, and how its terms take it.
struct NewRange {
    double minimum, maximum;
    TermsInRange terms;
};

/// Another range for a variable of a region's system, as editSystem() does it. Where terms stretch along,
/// what an input is set to does too: it stays the same word.
void setRange(Project& project, RegionId region, const VariablePlace& place, const NewRange& range,
              const EditScope& scope = {});

} // namespace esm
