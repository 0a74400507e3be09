#pragma once

#include "core/dynamics/global_terms.h"
#include "core/dynamics/schemes/step_scheme.h"
#include "core/dynamics/settings.h"

#include <optional>

namespace esm {

class TangentMatrix;

/// The integrators that solve for velocities, each by its StepForm, and what they carry from step to step.
class MatrixScheme : public StepScheme {
public:
    MatrixScheme(Integrator integrator, Damping damping) : m_integrator(integrator), m_damping(damping) {}

    UntouchedStep step(const SpringSystem& system, const StepInput& input, const Motion& before,
                       StepperSolvers& solvers) override;
    void remember(Motion before) override;
    void restart() override { m_previous.reset(); }

private:
    struct Start;
    struct Form;

    /// Empty when a step that builds on the last one would overshoot: it must then be taken without.
    /// @param solver holds the matrix of stepFactors()
    std::optional<UntouchedStep> solve(const Start& start, StepSolver& solver, bool builds);
    UntouchedStep firstStep(const Start& start, StepperSolvers& solvers);
    UntouchedStep branchStep(const Start& start, StepperSolvers& solvers);
    static void lead(const std::vector<PrescribedNode>& prescribed, const Form& form,
                     const Vectors& positions, Vectors& velocities);
    Form formOf(const StepInput& input, const Motion& before, bool builds) const;
    bool gainsEnergy(const Start& start, const Form& form, const TangentMatrix& tangent,
                     const Vectors& velocities) const;
    static void goBeyond(const Start& start, const Form& form, Vectors& velocities);
    static void innerForces(const Start& start, const Form& form, const Vectors& places, Vectors& forces);
    static double innerEnergy(const Start& start, const Form& form, const Vectors& places);
    static GlobalTerms fluidTerms(const Start& start, const Form& form);
    void notePressures(const Start& start, const Form& form);
    void foreseeDirectionsAlone(const Start& start, const Form& form, Vectors& extrapolated) const;
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
    std::optional<Motion> m_previous;                     ///< before the last step
    Vectors m_forces, m_previousForces;                   ///< elastic and of fluids, N
    std::vector<double> m_pressures, m_previousPressures; ///< Pa, by cavity
};

} // namespace esm
