#pragma once

#include "app/editor/workers/grasp.h"
#include "app/editor/workers/poke.h"
#include "app/editor/workers/prepared_project.h"
#include "app/editor/workers/preview_loads.h"
#include "app/editor/workers/preview_status.h"

#include <memory>
#include <optional>
#include <string>

namespace esm {

/// The simulation behind the window, run by the preview's thread alone.
class PreviewRun {
public:
    /// Takes a project; the motion goes on when the network is the same. False when it cannot be
    /// simulated: nothing moves until another project can be.
    bool take(PreparedProject prepared);
    /// Back to rest, and past what stopped the run.
    void reset();
    /// Plays the scene's loads from rest. Its clock is the simulation's; the steps are not cut where loads
    /// begin and end, a force counts with its mean over each.
    void beginScene();
    /// Where the scene's instruments are; none unless it plays or came to its end.
    std::vector<PlacedCollider> sceneInstruments() const;
    /// Where the instrument is that the hand leads: it goes no faster than a hand does in the tissue's own
    /// time. The mouse knows no such time, and where a second of the tissue takes long to compute it would
    /// be swept through it.
    const std::optional<PlacedCollider>& heldInstrument() const { return m_heldInstrument; }
    /// Stops the run for a reason, at the last good state that can be drawn.
    void stop(const std::string& reason);
    /// Steps until `seconds` are simulated, or more than that has been spent computing. Motion that runs
    /// wild, or comes to a step that cannot be computed, goes back to where it was calm and on in half as
    /// long steps, and where they are of no help as the program chooses, until the parameters change. False
    /// when the run stopped, as it does where nothing helps, or nothing can be drawn any more, and where the
    /// scene that plays is over; after that it goes on without the scene.
    bool advance(double seconds, const PreviewLoads& loads);
    /// Steps as advance() does until a time of its clock, s, under what the poke says of each moment and
    /// however long that takes. False when the run stopped.
    bool follow(const Poke& poke, double until);

    /// Steps as the program chooses from now on, where the project's step is far beyond the longest stable
    /// one: what rests looks calm until something touches it.
    void keepWithin(double safeStep);

    /// Whether the motion itself went wrong, as where an organ burst.
    bool hasFailed() const { return !m_runFailure.empty(); }
    bool isReady() const { return m_simulation && m_modelFailure.empty() && m_runFailure.empty(); }
    /// What runs. Precondition: a project was taken.
    const TissueModel& model() const { return *m_model; }
    /// Precondition: a project was taken.
    Integrator integrator() const { return m_simulation->integrator(); }
    double time() const { return m_simulation->time(); } ///< s since rest. Precondition: a project was taken
    const std::vector<Eigen::Vector3d>& positions() const;
    std::vector<double> speeds() const; ///< m/s, one per node; empty without a simulation
    const std::shared_ptr<const SpringNetwork>& network() const { return m_network; }
    PreviewStatus status() const;

private:
    void run(PreparedProject prepared);
    void leadInstrument(const std::optional<PlacedCollider>& target);
    void followLoads(const PreviewLoads& loads);
    bool step(const PreviewLoads& loads);
    Loads sceneLoads() const;
    bool isSceneOver() const;
    void leaveScene();
    bool goBack();
    bool endTurn();
    bool isReplaced() const { return m_replaced != Replaced::Not; }
    void replaceStepping(Replaced why);
    bool isDrawn() const;
    void measure(double simulated, double computing);
    Eigen::Vector3d toldImpulse() const;
    void measureForces(const Eigen::Vector3d& impulse, double simulated);
    std::optional<FeltTissue> feltPull() const;
    std::optional<FeltTissue> feltInstrument() const;
    std::vector<PartNow> fluidsNow() const;

    std::shared_ptr<const TissueModel> m_model;     ///< what runs; null before the first
    std::shared_ptr<const SpringNetwork> m_network; ///< of what runs, or cannot
    SimulationSettings m_settings; ///< the project's way to step, in steps that can be watched
    bool m_isShortened = false;    ///< the project's step
    std::optional<Simulation> m_simulation;
    std::optional<Grasp> m_pull, m_gentleGrasp;
    std::optional<PlacedCollider> m_heldInstrument;
    std::optional<GentlePull> m_gentlePull;
    double m_gentleTime = 0;
    Scene m_scene;
    bool m_playsScene = false; ///< its loads, not gravity alone
    Replaced m_replaced = Replaced::Not;
    int m_halvings = 0;                      ///< of the step, with this way to step
    int m_framesSinceKept = 0;               ///< since the state was kept
    double m_debt = 0;                       ///< s that were asked for and not simulated yet
    double m_simulated = 0, m_computing = 0; ///< s, decaying sums for the real-time factor
    ForceMean m_instrumentForce, m_pullForce;
    std::string m_modelFailure; ///< why the latest project cannot be simulated
    std::string m_runFailure;   ///< why the motion ended
};

} // namespace esm
