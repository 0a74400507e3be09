#pragma once

#include "app/esmc/report.h"
#include "core/exchange/model_package.h"
#include "core/model/project.h"

#include <filesystem>

namespace esm {

/// Counts, size, mass and repairs of a project, as `import` prints them.
Report modelReport(const Project& project);

/// The same of a model package, its surface counted anew.
Report modelReport(const ModelPackage& package);

/// True for a model package, false for what should be a project; told by the first bytes, else by the name.
bool isModelPackage(const std::filesystem::path& file);

} // namespace esm
