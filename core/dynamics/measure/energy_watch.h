#pragma once

#include "core/dynamics/motion.h"
#include "core/dynamics/node_ties.h"
#include "core/dynamics/settings.h"

#include <optional>
#include <string>

namespace esm {

/// Steps that were taken in a row under the same loads.
struct WatchedSteps {
    const Loads& loads;
    const Motion &before, &after;
    double duration;    ///< s, of each
    std::size_t count;  ///< 1 where nodes are led
    double contactWork; ///< J, that the instrument did
};

/// Tells steps that make energy out of nothing. Where a step is a little too long, the springs' law may bound
/// the swings, so that no place and no speed looks wrong; but they hold more energy than the loads ever gave.
/// Viscosity only takes energy away: the tissue must never hold more than the loads' work and what it held at
/// its start, as where rest lengths were rounded. Since steps are not exact, a quarter of all work that went
/// in or out, and of the energy at the start, is allowed besides.
class EnergyWatch {
public:
    /// Starts where the motion starts. The system outlives the watch.
    /// @param settings with the integrator that steps
    EnergyWatch(const SpringSystem& system, const SimulationSettings& settings, const Motion& start);

    /// Takes note of steps.
    void add(const WatchedSteps& steps);
    /// Whether so many were taken since the last look that another is worth its cost.
    bool isDue() const;
    /// Why the tissue cannot hold the energy it has after these steps; empty when it can. Precondition: they
    /// were the last to be added.
    std::string look(const WatchedSteps& steps);

private:
    double workOfLeading(const WatchedSteps& steps);
    double workOfFluidsOnLed(const WatchedSteps& steps) const;
    Eigen::Vector3d innerForceOn(std::uint32_t node, const Vectors& positions,
                                 const Vectors& velocities) const;

    const SpringSystem& m_system;
    Integrator m_integrator;
    Damping m_damping;
    double m_startEnergy;               ///< J
    double m_roundingEnergy;            ///< J, that rounding may add in one step
    double m_work = 0, m_grossWork = 0; ///< J
    std::size_t m_steps = 0, m_lookedAt = 0;
    std::optional<NodeTies> m_ties; ///< none until a node is led
};

/// The tissue's energy, J, in the form that an integrator keeps where nothing damps. Semi-implicit Euler,
/// `split` and Verlet keep the kinetic energy in the middle of a step plus ½·x⁻ᵀ·K·x⁺, an elastic energy that
/// belongs to both of its ends. The plain sum, which the others keep best, swings by a multiple of itself
/// near their longest steps. What constant loads do between the state's place and the step's middle is taken
/// off.
double keptEnergy(const SpringSystem& system, Integrator integrator, Damping damping,
                  const WatchedSteps& steps);

} // namespace esm
