#pragma once

#include "core/dynamics/contact/contact.h"
#include "core/dynamics/schemes/explicit_scheme.h"
#include "core/dynamics/schemes/instrument_touch.h"
#include "core/dynamics/schemes/matrix_scheme.h"
#include "core/dynamics/schemes/propagation.h"
#include "core/dynamics/strained_springs.h"

#include <map>
#include <variant>

namespace esm {

struct StepperOptions {
    ChosenStep chosen;
    SimulationSettings settings;
    ThreadTeam* team; ///< outlives the stepper; none is one thread
};

/// Steps one spring system by any of the integrators, leading nodes and making way for instruments: first
/// as if nothing touched the tissue, then with the impulses that its contacts ask for. Integrators that build
/// on earlier steps begin anew after every jump, of loads, of parameters or of a led node's velocity, and
/// while the tissue is touched; such a first step is one of the integrator that IntegratorTraits names.
/// Explicit ones begin anew in each step that leads nodes, which go evenly through it.
class Stepper {
public:
    /// @param former what stepped the same network before: orders and layouts that hang on the network alone
    /// are taken from it. May be null, or of another network.
    Stepper(SpringSystem system, TouchedSurface surface, const StepperOptions& options,
            const Stepper* former = nullptr);

    const SpringSystem& system() const { return m_system; }

    /// What is stepped at once.
    struct Request {
        const Loads& loads;                         ///< they name nodes of the system
        const std::vector<ColliderMove>& colliders; ///< the instruments' ways
        double duration;                            ///< s, of each step
        std::size_t count;                          ///< 1 when the loads touch something
    };
    /// Takes so many steps under the same loads. One of another length than the one before begins anew.
    void steps(Motion& motion, const Request& request);

    /// Whether steps are explicit and nothing is led or pushed.
    bool touchesNothing(const Loads& loads) const;

    /// Share of the nodes that the last steps were computed for.
    double activeFraction() const;

    /// s, wall time that this stepper and those it took over from have spent factorising.
    double factorisationSeconds() const { return m_free.factoriser->seconds() + m_led.factoriser->seconds(); }

    /// J, what the instruments did to the tissue in the last step.
    double contactWork() const { return m_contactWork; }
    /// Of the last step, one for each instrument.
    const std::vector<InstrumentTouch>& touches() const { return m_touches; }

    /// Forgets what earlier steps left behind, as when the motion was changed from outside.
    void restart();

private:
    using Scheme =
        std::variant<MatrixScheme, PropagationScheme, ExplicitScheme<double>, ExplicitScheme<float>>;

    /// Whether the other's explicit scheme does for this one, but for its parameters.
    bool canTakeScheme(const Stepper& former) const;
    Scheme makeScheme(const Stepper* former) const;
    void forgetSteps();

    /// A part of a step in which neither instruments nor tissue move far.
    struct Piece {
        StepInput input;
        bool isWhole; ///< the step in one piece
        std::vector<ColliderMove> colliders;
    };
    std::vector<Piece> piecesOf(const Motion& motion, const Request& request) const;
    void advance(Motion& motion, const Piece& piece);
    /// Whether led nodes change their velocities by more than smooth ways do. Takes note of them.
    bool jumps(const StepInput& input, const Vectors& positions);
    /// Explicit steps one after the other, without looking for contacts.
    bool explicitSteps(const StepInput& input, std::size_t count, const Motion& before, Motion& after);
    UntouchedStep untouchedStep(const Motion& motion, const Piece& piece);
    /// Without building on the step before.
    UntouchedStep firstOrderStep(const Motion& motion, const Piece& piece);
    /// The same with a constant matrix that follows the branches of the springs' law.
    UntouchedStep branchStep(const Motion& motion, const Piece& piece);
    /// Pushes the surface out of the instruments. Precondition: `untouched` did not build on the step before.
    Motion madeWay(const Motion& motion, const Piece& piece, UntouchedStep untouched);
    std::vector<char> immovable(const Piece& piece) const;
    /// Whether instruments touch what can give way. Takes note of them.
    bool touches(const Motion& motion, const Piece& piece, const Vectors& next);
    /// @param duration s, of the step or the part of it that is solved for
    StepSolver& solverFor(double duration, bool builds);
    /// Whether the matrix depends on what is strained.
    bool hasBranches() const;
    /// Each spring as stiff as on its branch; what is never strained far is as if its law were linear.
    StepSolver& branchSolverFor(double duration);
    void prescribe(const std::vector<HeldNode>& held);

    SpringSystem m_system;
    TouchedSurface m_surface;
    StepperOptions m_options;
    Integrator m_integrator;
    double m_duration; ///< s, of the last step
    std::vector<InstrumentTouch> m_touches;
    double m_contactWork = 0; ///< J

    /// The matrices of the tissue with some nodes prescribed.
    struct Solvers {
        std::vector<char> prescribed;
        std::shared_ptr<MatrixFactoriser> factoriser; ///< one stepper after the other has it
        std::map<std::pair<long, bool>, std::unique_ptr<StepSolver>> linear; ///< by length and form
        std::map<long, std::unique_ptr<StepSolver>> branches;                ///< by length

        Solvers(std::vector<char> nodes, std::shared_ptr<MatrixFactoriser> used)
            : prescribed(std::move(nodes)), factoriser(std::move(used)) {}
    };
    Solvers& solvers() { return m_leadsMany ? m_led : m_free; }
    void forgetBranches();

    bool m_leadsMany = false;
    Solvers m_free; ///< of the fixed nodes
    Solvers m_led;  ///< of these and the led ones, as they were when many were led last
    StrainedSprings m_strained;

    /// How a node was led in the last step, on the mean.
    struct LedNode {
        std::uint32_t node;
        Eigen::Vector3d velocity; ///< m/s
    };
    std::vector<LedNode> m_ways;
    std::optional<Loads> m_lastLoads;
    Scheme m_scheme;
};

} // namespace esm
