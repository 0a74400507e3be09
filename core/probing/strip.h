#pragma once

#include "core/probing/probe.h"

namespace esm {

/// A strip that is cut out of an organ, clamped at both ends and stretched.
struct StripSettings {
    Eigen::Vector3d place; ///< m, on the organ's surface: the strip's middle
    /// From one clamp to the other, of any length; without, the direction in which the organ is longest,
    /// along its surface
    std::optional<Eigen::Vector3d> along{};
    double turn = 0;       ///< radians, that it is turned by from there, to the left as seen from outside
    double length = 0.04;  ///< m, between the clamps
    double width = 0.01;   ///< m; that of a solid organ is cut out as deep
    double stretch = 0.05; ///< to which it is stretched, of the length
    int steps = 10;        ///< stretches at which the force is measured
    /// m, of the wall of a hollow organ; none: its Young's modulus is not known
    std::optional<double> wallThickness{};
};
inline constexpr double largestStretch = 1;

/// A strip that has come to rest between its clamps.
struct StripPoint {
    double elongation; ///< m, by which the clamps are further apart
    double strain;     ///< of the tissue in the middle, which the clamps do not disturb
    double force;      ///< N, with which each clamp pulls
};

/// What a strip tells.
struct StripResult {
    Eigen::Vector3d place;         ///< m, on the surface that is simulated
    Eigen::Vector3d along;         ///< of length 1
    std::vector<StripPoint> curve; ///< by rising elongation, from none on
    double stiffnessAtStart = 0;   ///< N/m, of the first step
    double stiffness = 0;          ///< N/m, of the last one
    /// N/m, of a wall: force by its width and strain. That is Young's modulus times thickness. None of
    /// solids, and where the strip is slack to the end
    std::optional<double> membraneStiffness;
    std::optional<double> youngsModulus; ///< Pa, of the last step; none where it is slack or not known
    std::size_t nodeCount = 0;           ///< of the strip
};

/// Cuts a strip out, without what holds the organ, and stretches it. Forces are those at rest.
/// @throws InvalidModel for settings that are no test of this organ (off its surface, longer than it is,
/// finer than its nodes, …), for an organ without springs to stretch, and where the tissue finds no balance
/// @throws Cancelled
StripResult pullStrip(const ProbedOrgan& organ, const StripSettings& settings, const Progress& progress = {});

} // namespace esm
