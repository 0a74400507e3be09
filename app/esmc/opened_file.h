#pragma once

#include "app/esmc/context.h"
#include "core/exchange/model_package.h"

namespace esm {

// What is wrong with a file that can be opened all the same is warned of with the command's report.
Project openedProject(const std::filesystem::path& file, Context& context);      ///< @throws FileError
ModelPackage openedPackage(const std::filesystem::path& file, Context& context); ///< @throws FileError

} // namespace esm
