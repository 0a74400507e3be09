#pragma once

#include "app/editor/edits/system_reach.h"
#include "core/fuzzy/system_edits.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <string>

namespace esm {

/// Asks for a variable's name, as rules write it. None where the user would rather not.
std::optional<std::string> askVariableName(QWidget& window, const QString& title,
                                           const std::string& proposal);

/// Asks whether the rules that speak of something may go with it, where there are any.
bool mayTakeRulesAlong(QWidget& window, const FuzzySystem& system, const QString& what,
                       const std::vector<std::size_t>& rules);

/// Asks whether an edit of a system that several regions use is for all of them, or for a copy that the
/// selected one gets. None where the user would rather not edit.
std::optional<Reach> askReach(QWidget& window, const FuzzySystem& system, const QString& selected,
                              const std::vector<const Region*>& users);

} // namespace esm
