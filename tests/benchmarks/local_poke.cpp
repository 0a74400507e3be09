#include "tests/benchmarks/local_poke.h"

#include "core/dynamics/simulation.h"
#include "tests/support/tissue_models.h"

namespace benchmarks {

namespace {

constexpr int nodesPerSide = 450;
constexpr std::uint32_t poked = nodesPerSide / 2 * (nodesPerSide + 1);
constexpr double pokeTimeStep = 5e-5, pokeTolerance = 1e-5; ///< s, m
constexpr std::size_t pokeSteps = 1000, restSteps = 1000, wholeSteps = 64;
constexpr int pokeRepetitions = 5;

/// Weakly damped: what swings does so a dozen times. Every node is tethered.
esm::TissueModel weaklyDampedTissue() {
    esm::TissueModel model = tissue::fromMesh(tissue::gridMesh(nodesPerSide, 0.5), {40, 1e-3, 1e-5});
    for (std::uint32_t node = 0; node < model.mass.size(); ++node)
        model.tethers.push_back({node, 20, 4e-3});
    return model;
}

class Poke {
public:
    Poke(double restTolerance, esm::Precision precision)
        : m_simulation(weaklyDampedTissue(), settings(restTolerance, precision)) {
        m_force.forces = {{poked, {0.02, 0.04, 0.1}}};
    }
    void press(std::size_t steps) { m_simulation.advance(m_force, steps); }
    void letGo(std::size_t steps) { m_simulation.advance({}, steps); }

private:
    static esm::SimulationSettings settings(double restTolerance, esm::Precision precision) {
        esm::SimulationSettings result;
        result.integrator = esm::Integrator::Euler;
        result.timeStep = pokeTimeStep;
        result.precision = precision;
        result.restTolerance = restTolerance;
        result.threads = 1;
        return result;
    }

    esm::Simulation m_simulation;
    esm::Loads m_force;
};

void registerPoke(const std::string& name, esm::Precision precision, std::vector<Ratio>& ratios) {
    const std::string local = name + ", poke of 2000 steps", whole = name + ", 64 whole steps";
    registerWork(local, pokeRepetitions, [precision] {
        return [poke = std::make_shared<Poke>(pokeTolerance, precision)] {
            poke->press(pokeSteps);
            poke->letGo(restSteps);
        };
    });
    registerWork(whole, pokeRepetitions, [precision] {
        return [poke = std::make_shared<Poke>(0, precision)] { poke->press(wholeSteps); };
    });
    const double scale = double(wholeSteps) / double(pokeSteps + restSteps);
    ratios.push_back(
        {name + ", 202 k: local poke to whole step", local, whole, Clock::Thread, 0, 0.02, scale});
}

} // namespace

std::vector<Ratio> registerLocalPoke() {
    std::vector<Ratio> ratios;
    registerPoke("float", esm::Precision::Float, ratios);
    registerPoke("double", esm::Precision::Double, ratios);
    return ratios;
}

} // namespace benchmarks
