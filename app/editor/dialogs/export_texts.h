#pragma once

#include "app/editor/workers/difference_finder.h"

#include <QString>

namespace esm {

/// How far the search for what will differ is. @param exports whether the organ is exported then
QString searchText(double share, bool exports);

/// What will differ, as rich text.
QString differencesText(const Differences& differences);

/// Which steps are stable and who takes them; empty where nobody steps the organ.
QString stepsText(const Differences& differences);

/// That the step blows up the motion or may make it another one, and why; empty where it does not.
QString poorStepText(const Differences& differences);

} // namespace esm
