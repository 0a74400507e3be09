#pragma once

#include "core/dynamics/schemes/step_solver.h"
#include "core/dynamics/settings.h"

#include <optional>

namespace esm {

class TangentMatrix;

/// The integrators that solve for velocities, each by its StepForm, and what they carry from step to step.
class MatrixScheme {
public:
    MatrixScheme(Integrator integrator, Damping damping) : m_integrator(integrator), m_damping(damping) {}

    /// Whether a step can build on the last one.
    bool canBuild() const { return m_previous.has_value(); }

    /// One step, as if nothing touched the tissue. The solver holds the matrix of stepFactors(). Empty when a
    /// step that builds on the last one would overshoot: it must then be taken without.
    /// @throws InvalidModel when no solution is found
    std::optional<UntouchedStep> step(const SpringSystem& system, const StepInput& input,
                                      const Motion& before, StepSolver& solver, bool builds);

    /// The next step may build on the one that started here. Precondition: it was the last to be computed.
    void remember(Motion before);

    /// Forgets what earlier steps left behind.
    void restart() { m_previous.reset(); }

private:
    struct Start;
    struct Form;

    static void lead(const std::vector<HeldNode>& held, const Form& form, const Vectors& positions,
                     Vectors& velocities);
    Form formOf(const StepInput& input, const Motion& before, bool builds) const;
    bool gainsEnergy(const Start& start, const Form& form, const TangentMatrix& tangent,
                     const Vectors& velocities) const;
    static void goBeyond(const Start& start, const Form& form, Vectors& velocities);
    void solveConstant(const Start& start, const Form& form, StepSolver& solver, UntouchedStep& step) const;
    bool solveTangent(const Start& start, const Form& form, StepSolver& solver, UntouchedStep& step) const;
    void solveTurning(const Start& start, const Form& form, StepSolver& solver, Vectors& velocities) const;
    SpringSystem axiallyDamped(const Start& start, const Form& form) const;
    double takeDownhill(const Start& start, const Form& form, const Vectors& change,
                        Vectors& velocities) const;
    Vectors momentum(const Start& start, const Form& form, const Vectors& stiffened) const;
    static Vectors placesAfter(const Start& start, const Form& form, const Vectors& velocities);
    void addShareBefore(const Form& form, Vectors& forces) const;
    Vectors missing(const Start& start, const Form& form, const Vectors& places,
                    const Vectors& velocities) const;
    double potential(const Start& start, const Form& form, const Vectors& velocities) const;

    Integrator m_integrator;
    Damping m_damping;
    std::optional<Motion> m_previous;   ///< before the last step
    Vectors m_forces, m_previousForces; ///< elastic, N
};

} // namespace esm
