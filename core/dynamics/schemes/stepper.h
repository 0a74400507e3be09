#pragma once

#include "core/dynamics/contact/contact.h"
#include "core/dynamics/prepared_model.h"
#include "core/dynamics/schemes/instrument_touch.h"
#include "core/dynamics/schemes/step_scheme.h"

namespace esm {

/// Steps one spring system by any of the integrators, leading nodes and making way for instruments: first
/// as if nothing touched the tissue, then with the impulses that its contacts ask for. Integrators that build
/// on earlier steps begin anew after every jump, of loads, of parameters or of a led node's velocity, and
/// while the tissue is touched; such a first step is one of the integrator that IntegratorTraits names.
/// Explicit ones begin anew in each step that leads nodes, which go evenly through it, and step as symplectic
/// Euler while the tissue is touched.
class Stepper {
public:
    /// @param team outlives the stepper; null is one thread
    /// @param former what stepped the same network before: the kernel's layout, which hangs on the network
    /// alone, is taken from it. May be null, or of another network.
    Stepper(PreparedModel model, TouchedSurface surface, ThreadTeam* team, const Stepper* former = nullptr);

    const SpringSystem& system() const { return m_system; }
    /// Knows the network's order of elimination.
    const std::shared_ptr<MatrixFactoriser>& factoriser() const { return m_solvers.factoriser(); }

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
    double activeFraction() const { return m_scheme->activeFraction(); }

    /// s, wall time that this stepper and those it took over from have spent factorising.
    double factorisationSeconds() const { return m_solvers.factorisationSeconds(); }

    /// J, what the instruments did to the tissue in the last step.
    double contactWork() const { return m_contactWork; }
    /// Of the last step, one for each instrument.
    const std::vector<InstrumentTouch>& touches() const { return m_touches; }

    /// Forgets what earlier steps left behind, as when the motion was changed from outside.
    void restart();

private:
    /// Whether the other's scheme does for this one, but for its parameters.
    bool canTakeScheme(const Stepper& former) const;
    std::unique_ptr<StepScheme> makeScheme(const Stepper* former) const;

    /// A part of a step in which neither instruments nor tissue move far.
    struct Piece {
        StepInput input;
        bool isWhole; ///< the step in one piece
        std::vector<ColliderMove> colliders;
    };
    std::vector<Piece> piecesOf(const Motion& motion, const Request& request) const;
    /// In so many parts of the same length, from these positions on.
    static std::vector<Piece> cut(const Piece& whole, int parts, const Vectors& positions);
    void advance(Motion& motion, const Piece& piece);
    /// @param untouched the scheme's step, which something touches
    void advanceTouched(Motion& motion, const Piece& piece, UntouchedStep untouched);
    void prepareTouchedScheme();
    void makeWay(Motion& motion, const Piece& piece, UntouchedStep untouched);
    /// Whether led nodes change their velocities by more than smooth ways do. Takes note of them.
    bool jumps(const StepInput& input, const Vectors& positions);
    UntouchedStep untouchedStep(StepScheme& scheme, const Motion& motion, const Piece& piece);
    /// Pushes the surface out of the instruments. Precondition: `untouched` did not build on the step before.
    Motion madeWay(const Motion& motion, const Piece& piece, UntouchedStep untouched);
    std::vector<char> immovable(const Piece& piece) const;
    /// Whether instruments touch what can give way. Takes note of them.
    bool touches(const Motion& motion, const Piece& piece, const Vectors& next);
    SpringSystem m_system;
    TouchedSurface m_surface;
    SimulationSettings m_settings;
    ThreadTeam* m_team;
    Integrator m_integrator;
    double m_timeStep; ///< s, that was chosen
    double m_duration; ///< s, of the last step
    std::vector<InstrumentTouch> m_touches;
    double m_contactWork = 0; ///< J

    /// How a node was led in the last step, on the mean.
    struct PrescribedWay {
        std::uint32_t node;
        Eigen::Vector3d velocity; ///< m/s
    };
    std::vector<PrescribedWay> m_ways;
    std::optional<Loads> m_lastLoads;
    StepperSolvers m_solvers;
    std::unique_ptr<StepScheme> m_scheme;
    std::unique_ptr<StepScheme> m_touchedScheme; ///< of explicit steps of a higher order; null until touched
    double m_longestTouchedStep = 0;             ///< s, of it that is stable
};

} // namespace esm
