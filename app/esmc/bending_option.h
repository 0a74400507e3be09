#pragma once

#include "app/esmc/report.h"
#include "core/project/project.h"

#include <CLI/CLI.hpp>

#include <optional>

namespace esm {

/// How thick the wall is that resists bending, as it is said on the command line.
struct BendingOption {
    bool isGiven = false;
    std::optional<double> thickness; ///< m; none: it bends freely
};

/// --bending
void declareBending(CLI::App& command, BendingOption& option);

/// Leaves the organ as it is where nothing was said. @throws UsageError where the organ has no wall
void setBending(Project& project, const BendingOption& option);

/// `bending_thickness` in JSON, m, null where the wall bends freely.
void addBending(Report& report, const BaseTissue& base, const SpringNetwork& network);

} // namespace esm
