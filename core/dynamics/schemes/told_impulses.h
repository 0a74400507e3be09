#pragma once

#include "core/dynamics/contact/contact_impulses.h"
#include "core/dynamics/schemes/instrument_touch.h"
#include "core/dynamics/schemes/step_solver.h"
#include "core/dynamics/settings.h"

namespace esm {

/// How instruments pushed in one step, or a part of one.
struct MadeWay {
    const SpringSystem& system;
    Integrator integrator;
    Damping damping;
    double duration;                     ///< s
    const Vectors& before;               ///< positions, m
    const Vectors &free, &solved;        ///< velocities without contacts and with them, m/s
    const ContactProblem& problem;       ///< with the contacts that were pushed
    const Eigen::VectorXd& impulses;     ///< N·s, one per contact
    const std::vector<NodePush>& pushes; ///< after that
};

/// Adds to each instrument's impulse what the tissue gave it.
void tellImpulses(const MadeWay& way, StepSolver& solver, std::vector<InstrumentTouch>& touches);

} // namespace esm
