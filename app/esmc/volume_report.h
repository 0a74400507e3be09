#pragma once

#include "app/esmc/report.h"
#include "core/dynamics/measure/scene_run.h"

namespace esm {

/// How a pressure is told to people who know one unit or the other.
std::string pressureInText(double pascal);

/// What each filled part enclosed at the record times, and what pressed from within.
void addVolumes(Report& report, const TissueModel& tissue, const std::vector<FluidRow>& rows);

} // namespace esm
