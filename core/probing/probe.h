#pragma once

#include "core/dynamics/contact/touched_surface.h"
#include "core/model/tissue_model.h"
#include "core/support/progress.h"

#include <optional>
#include <vector>

namespace esm {

/// The force on a finger that has come to rest at a depth.
struct PressPoint {
    double depth; ///< m
    double force; ///< N
};

/// A finger's depth and force as time goes on.
struct TimedPress {
    double time;  ///< s
    double depth; ///< m
    double force; ///< N
};

/// What follows a finger that stays at a depth, or goes on under a force.
struct TimeCurve {
    std::vector<TimedPress> points;
    PressPoint end; ///< where it ends after any time
    /// s, after which 1/e of the way to the end is left: of the depth under a force from the first moment on,
    /// of the force at a depth from where it is largest once the finger stands. None where that is not
    /// reached, or there is next to no way
    std::optional<double> timeConstant;
    bool meetsFixed = false; ///< the finger also lay on fixed nodes, whose force is not counted
};

/// The finger is at a depth within `rise`, and stays there.
struct RelaxationTest {
    double duration;    ///< s, of the whole
    double rise = 0.05; ///< s
};
/// The finger is pushed with a force from the first moment on.
struct CreepTest {
    double force;    ///< N
    double duration; ///< s
};

/// A finger, a rigid sphere without friction, that is pressed into an organ along a line.
struct ProbeSettings {
    Eigen::Vector3d place; ///< m, on the organ's surface at rest, without a pressure
    /// Into the organ, of any length; without, against the mean direction in which the surface faces within a
    /// radius of the place
    std::optional<Eigen::Vector3d> direction{};
    double radius = 0.008; ///< m, of a finger's tip
    double depth = 0.004;  ///< m, counted from where the finger first touches
    int steps = 10;        ///< depths at which the force is measured
    std::optional<RelaxationTest> relaxation{};
    std::optional<CreepTest> creep{};
};
inline constexpr int mostProbeSteps = 1000;
inline constexpr double shortestTest = 1e-6, longestTest = 1e6; ///< s, of a test in time

/// A part of the organ as it stands under a pressure, before a finger comes.
struct InflatedPart {
    std::uint32_t part;        ///< as of a cavity
    double pressure;           ///< Pa, that loads lay on it
    double volume, restVolume; ///< m³
};

/// What a virtual test tells.
struct ProbeResult {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();     ///< m, on the surface that is simulated, at rest
    Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< into the organ, of length 1
    std::vector<PressPoint> curve;                       ///< from (0, 0) on, by rising depth
    double stiffnessAtStart = 0;                         ///< N/m, of the first step
    double stiffness = 0;                                ///< N/m, of the last one
    double poissonsRatio = 0;                            ///< 1/4 of lattices, 1/3 of nets
    /// Pa, of the even solid, wide and deep beside the finger, that resists as much at the full depth
    double youngsModulus = 0;
    std::optional<TimeCurve> relaxation, creep;
    std::vector<InflatedPart> inflated{}; ///< all that a pressure acts in
    bool meetsFixed = false;              ///< in any of these the finger also lay on fixed nodes
};

/// What is probed: its tissue, and what of it a finger touches.
struct ProbedOrgan {
    const TissueModel& model;
    const TouchedSurface& surface;
};

/// Presses an organ that rests under the pressures that its scene begins with, without gravity or other
/// loads. Depths count from where the finger touches it there. Forces are those at rest, to a thousandth or
/// better; parts that nothing holds stay where they are.
/// @throws InvalidModel for settings that are no test of this organ (off its surface, deeper than it is, …),
/// for an organ that cannot be pressed (rigid, all of it fixed, none of it held), and where the tissue finds
/// no balance, as where a pressure bursts it
/// @throws Cancelled
ProbeResult probe(const ProbedOrgan& organ, const ProbeSettings& settings, const Progress& progress = {});

/// N, of a rigid sphere in an even half-space without friction (Hertz 1881): F = 4/3·E*·√R·δ^{3/2}, where E*
/// is E/(1 − ν²).
double hertzForce(double youngsModulus, double poissonsRatio, double radius, double depth);
/// Pa, of the half-space that resists so much.
double hertzModulus(const PressPoint& press, double poissonsRatio, double radius);

} // namespace esm
