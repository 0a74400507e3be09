#pragma once

#include "app/esmc/project_output.h"
#include "app/esmc/report.h"
#include "core/exchange/model_package.h"
#include "core/project/project.h"

namespace esm {

/// Counts, size, mass and repairs of a project, as `import` prints them.
Report modelReport(const Project& project);

/// The same of a model package, without the repairs: its surface is counted anew.
Report modelReport(const ModelPackage& package);

/// The law of all springs: `stiffening` in JSON, null where they are linear.
void addSpringLaw(Report& report, const std::optional<SpringStiffening>& stiffening);

/// Saves a project and reports it.
Report saveAndReport(const Project& project, const ProjectOutput& output);

} // namespace esm
