#pragma once

#include "core/dynamics/contact/touched_surface.h"
#include "core/dynamics/energy.h"
#include "core/dynamics/motion.h"
#include "core/dynamics/prepared_model.h"
#include "core/dynamics/schemes/instrument_touch.h"
#include "core/dynamics/settings.h"
#include "core/model/tissue_model.h"
#include "core/model/topology.h"

#include <memory>
#include <string>
#include <vector>

namespace esm {

/// A running model. One thread at a time.
class Simulation {
public:
    /// Starts at rest. `surface` is what instruments touch; may be empty.
    /// @throws InvalidModel with every problem of model or settings (a step that is not above zero, split
    /// with axial damping, …)
    Simulation(const TissueModel& model, const SimulationSettings& settings, TouchedSurface surface = {});
    explicit Simulation(PreparedModel model, TouchedSurface surface = {});
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;
    ~Simulation();

    Integrator integrator() const;
    double timeStep() const;                                ///< s
    double time() const;                                    ///< s since the start
    const std::vector<Eigen::Vector3d>& positions() const;  ///< m, one per node
    const std::vector<Eigen::Vector3d>& velocities() const; ///< m/s
    const Motion& motion() const;                           ///< both
    const SpringSystem& system() const;                     ///< until it is another one
    Energy energy() const;

    /// Advances by one step. When the result is not finite or went farther than the loads can have driven it,
    /// the state before the step stays and false is returned; failure() then says why. Instruments sweep from
    /// where the step before left them; one that was not there before appears where it is.
    /// @throws InvalidModel when the step cannot be computed, as with too little mass for the viscosity; the
    /// state before the step stays, and failure() says why
    bool step(const Loads& loads);
    const std::string& failure() const;
    /// J, what instruments have done to the tissue since the start.
    double contactWork() const;
    /// Since the start, by the instruments' places in the loads.
    const std::vector<InstrumentTouch>& instrumentTouches() const;

    /// The same with a step of another length, which ends at a later time, s: where a load begins, ends or
    /// turns between two steps.
    bool stepTo(double time, const Loads& loads);

    /// Advances by up to `count` steps under the same loads; how many were taken. They are judged some at a
    /// time, so that after a failure the state is one of a few steps before. @throws InvalidModel as step()
    std::size_t advance(const Loads& loads, std::size_t count);

    /// Share of the nodes that were computed, on the mean of all steps.
    double activeFraction() const;

    /// s, wall time spent factorising so far, set-up included.
    double factorisationSeconds() const;

    /// Where the instruments stand before the next step.
    void placeInstruments(std::vector<ColliderPose> poses);

    /// Takes new parameters for the same network, motion and instruments going on, and settings where they
    /// are new too; as many threads step as before. States that were kept stay so; without any, the one there
    /// is now is kept. @throws InvalidModel, also where setTopology() was called since the last reset(),
    /// which would not know what the whole tissue is now
    void setModel(const TissueModel& model);
    void setModel(const TissueModel& model, const SimulationSettings& settings);
    /// The same without the time that it takes to choose a step and to factorise its matrices.
    void setModel(PreparedModel model);

    /// Goes on in tissue with other nodes, springs or triangles, as after a cut: motion and kept states as
    /// the map says, instruments and what they did as they are. Steps stay as long as they are. reset()
    /// brings the tissue back that the run began with. @throws InvalidModel
    void setTopology(const TissueModel& model, const NodeMap& map, TouchedSurface surface = {});

    /// Keeps the state as it is now, and with it the one that was kept last.
    void keepState();
    /// Back to the older of the two states that were kept last, or to rest without two: a run that diverges
    /// was already on its way when the younger one was kept. From there steps are `timeStep` (s) long, until
    /// setModel() chooses anew. @throws InvalidModel as step()
    void goBack(double timeStep);

    /// Back to rest at time 0, without instruments, and with the nodes that there were then. @throws
    /// InvalidModel after setTopology() where the matrices of that time cannot be made again; the tissue is
    /// then as it was
    void reset();

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_implementation;
};

} // namespace esm
