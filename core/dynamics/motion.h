#pragma once

#include "core/dynamics/loads.h"
#include "core/dynamics/spring_system.h"

namespace esm {

struct Motion {
    Vectors positions;  ///< m
    Vectors velocities; ///< m/s
};

/// What acts during a step, or during a part of one.
struct StepInput {
    double duration; ///< s
    const Loads* loads;
    std::vector<PrescribedNode> prescribed; ///< where they are at the end; no fixed node, each once
};

/// f + g: adds gravity and the forces on single nodes, N.
inline void addExternalForces(const SpringSystem& system, const Loads& loads, Vectors& forces) {
    if (!loads.gravity.isZero(0))
        for (std::size_t i = 0; i < forces.size(); ++i)
            forces[i] += system.mass[i] * loads.gravity;
    for (const auto& [node, force] : loads.forces)
        forces[node] += force;
}

/// Gives the led nodes the velocities, m/s, that take them where they are led.
inline void leadPrescribedNodes(const StepInput& input, const Vectors& positions, Vectors& velocities) {
    for (const PrescribedNode& led : input.prescribed)
        velocities[led.node] = (led.position - positions[led.node]) / input.duration;
}

/// Puts the led nodes exactly where they are led, which rounding alone would miss.
inline void placePrescribedNodes(const StepInput& input, Vectors& positions) {
    for (const PrescribedNode& led : input.prescribed)
        positions[led.node] = led.position;
}

} // namespace esm
