#pragma once

#include "core/dynamics/measure/tradeoff.h"
#include "core/project/project.h"

namespace esm {

/// What speed and accuracy are measured on: the project's own scene; where nothing in it moves the tissue, a
/// second in which a patch at the organ's edge is drawn outwards and held.
/// @throws InvalidModel when every node is fixed
Scene measuredScene(const Project& project);

/// Measures every way to step the project's tissue, on all its nodes and on fewer. Seconds for a small organ,
/// minutes for a large one.
/// @throws InvalidModel; Cancelled
Tradeoff measureAccuracy(const Project& project, const TradeoffOptions& options, const Progress& progress);

/// The project with what was measured of it in a scene, on all of its nodes.
Project withAccuracy(const Project& project, const Scene& scene, const Tradeoff& measured);

/// The organ that measurements of the project hold for, as it is now.
MeasuredOrgan measuredOrgan(const Project& project);

/// Whether what was measured still holds for the organ, on all its nodes or on those of the run in use.
/// Precondition: speed and accuracy of the project were measured.
bool isMeasuredOn(const Project& project, const MeasuredOrgan& organ);

/// The project with a run of its measurement as the way to step it that is recommended, on the nodes of that
/// run. What was measured still holds for it where it did for the project. Precondition: speed and accuracy
/// of the project were measured, and the run did not run wild. @param run its place among the runs
/// @throws InvalidModel when the surface has no such level of detail; Cancelled
Project withMeasuredRun(const Project& project, std::size_t run, const Progress& progress = {});

} // namespace esm
