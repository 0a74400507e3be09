#include "core/dynamics/schemes/step_solver.h"

#include "core/dynamics/schemes/schemes.h"

namespace esm {

MatrixFactors stepFactors(Integrator integrator, double duration, bool builds) {
    return schemeOf(builds ? integrator : traitsOf(integrator).startsAs).factors(duration);
}

std::vector<std::uint32_t> ledByImpulses(const StepMatrix& matrix,
                                         const std::vector<PrescribedNode>& prescribed) {
    std::vector<std::uint32_t> led;
    for (const PrescribedNode& node : prescribed)
        if (!matrix.isGiven(node.node)) led.push_back(node.node);
    return led;
}

} // namespace esm
