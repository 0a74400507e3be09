#pragma once

#include "app/esmc/report.h"
#include "core/project/project.h"

#include <CLI/CLI.hpp>

#include <optional>

namespace esm {

/// How thick the wall is that resists bending, as it is said on the command line.
struct WallOption {
    bool isGiven = false;
    std::optional<double> thickness; ///< m; none: it bends freely
};

/// --wall-thickness
void declareWall(CLI::App& command, WallOption& option);

/// Leaves the organ as it is where nothing was said. @throws UsageError where the organ has no wall
void setWall(Project& project, const WallOption& option);

/// `bending_thickness` in JSON, m, null where the wall bends freely.
void addBending(Report& report, const BaseTissue& base, const SpringNetwork& network);

} // namespace esm
