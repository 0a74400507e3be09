#pragma once

#include "core/dynamics/settings.h"
#include "core/model/tissue_model.h"

#include <vector>

/// A witness of where tissue goes, for tests that ask how far a run is off. It shares no forces and no steps
/// with the program: the equations of motion in plain numbers, solved by Dormand and Prince's pair of the
/// fifth and fourth order (1980) in steps of its own choice, with a stop at every corner of the loads. That
/// is slow, but of small tissue it is exact to many digits, stiff or not.
namespace reference {

using Vectors = std::vector<Eigen::Vector3d>; ///< one per node

/// What moves: tissue from rest under a scene without an instrument.
struct Experiment {
    const esm::TissueModel& model;
    const esm::Scene& scene;
    esm::Damping damping = esm::Damping::Isotropic;
};

/// Places of all nodes, m, at so many times, s, which increase from 0 or later.
/// @param tolerance m, what each step may be off
std::vector<Vectors> placesAt(const Experiment& experiment, const std::vector<double>& times,
                              double tolerance);

struct ExactMotion {
    std::vector<Vectors> places; ///< m, at each of the times
    double error = 0;            ///< an upper estimate, relative to the motion
};

/// The same as exactly as double precision is worth asking.
ExactMotion exactMotion(const Experiment& experiment, const std::vector<double>& times);

/// √(Σ|x − x_ref|² / Σ|x_ref − x_0|²), as the program defines the error of a trajectory.
double relativeDifference(const std::vector<Vectors>& motion, const std::vector<Vectors>& exact,
                          const Vectors& rest);

} // namespace reference
