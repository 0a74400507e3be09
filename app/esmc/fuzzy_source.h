#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <memory>
#include <string>

namespace esm {

/// A fuzzy system by the name of its file or of a preset. A name with a folder or an ending, or of a file
/// that is there, is a file's.
/// @throws FileError, InvalidModel
std::shared_ptr<const FuzzySystem> loadFuzzySystem(const std::string& name);

} // namespace esm
