#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <QWidget>

#include <functional>
#include <memory>

namespace esm {

/// Asks for a fuzzy system's file (JSON, FCL or FLL), hands its system to `use`, and tells what of the file
/// could not be taken.
void openFuzzySystem(QWidget* window,
                     const std::function<void(const std::shared_ptr<const FuzzySystem>&)>& use);

/// Asks where to write the system, in which of the languages, and tells what the language cannot hold.
void saveFuzzySystem(QWidget* window, const FuzzySystem& system);

} // namespace esm
