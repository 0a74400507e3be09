#include "core/dynamics/schemes/step_solver.h"

namespace esm {

MatrixFactors stepFactors(Integrator integrator, double duration, bool builds) {
    const double h = duration;
    if (isExplicit(integrator)) return {1, 0, 0};
    if (integrator == Integrator::Split || integrator == Integrator::Split2) return {builds ? 1.5 : 1, h, 0};
    return builds ? MatrixFactors{1.5, h, h * h * 2 / 3} : MatrixFactors{1, h, h * h};
}

std::vector<std::uint32_t> ledByImpulses(const StepMatrix& matrix, const std::vector<HeldNode>& held) {
    std::vector<std::uint32_t> led;
    for (const HeldNode& node : held)
        if (!matrix.isPrescribed(node.node)) led.push_back(node.node);
    return led;
}

} // namespace esm
