#include "core/dynamics/measure/watched_run.h"

namespace esm {

WatchedRun::WatchedRun(const Simulation& simulation, const SimulationSettings& settings)
    : m_simulation(simulation), m_watch(simulation.system(), settings, simulation.motion()) {}

// A copy of the motion costs less than a step, and the watch needs where the tissue was.
void WatchedRun::begin() {
    m_before = m_simulation.motion();
    m_contactWork = m_simulation.contactWork();
}

std::string WatchedRun::problemAfter(const Loads& loads, double duration, std::size_t count, bool isLast) {
    const double contactWork = m_simulation.contactWork() - m_contactWork;
    const WatchedSteps steps{loads, m_before, m_simulation.motion(), duration, count, contactWork};
    m_watch.add(steps);
    return isLast || m_watch.isDue() ? m_watch.look(steps) : std::string();
}

} // namespace esm
