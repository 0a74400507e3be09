#pragma once

#include "core/dynamics/measure/energy_watch.h"
#include "core/dynamics/simulation.h"

namespace esm {

/// Holds the energy after a simulation's steps against the work of their loads.
class WatchedRun {
public:
    /// Starts where the simulation stands, which outlives this. @param settings with the integrator that
    /// steps
    WatchedRun(const Simulation& simulation, const SimulationSettings& settings);

    /// To be called before steps are taken.
    void begin();
    /// Why the steps since, each of `duration` s, cannot be right; empty when they can, or when it is not yet
    /// time to look.
    std::string problemAfter(const Loads& loads, double duration, std::size_t count, bool isLast);

private:
    const Simulation& m_simulation;
    EnergyWatch m_watch;
    Motion m_before;
    double m_contactWork = 0; ///< J
};

} // namespace esm
