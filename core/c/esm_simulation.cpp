#include "core/c/esm_package.h"
#include "core/c/failure.h"
#include "core/c/package_arrays.h"
#include "core/dynamics/given_loads.h"
#include "core/dynamics/measure/scene_loads.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "core/support/errors.h"

#include <algorithm>
#include <array>
#include <cmath>

struct EsmSimulation {
    std::shared_ptr<const esm::PackagedTissue> package;
    esm::Simulation simulation;
    esm::Loads loads{};
};

namespace esm {

namespace {

/// What a caller hands over, who may not have asked whether it could be opened or made.
const EsmPackage& required(const EsmPackage* package) {
    if (!package) throw InvalidModel("the package is NULL: it was not opened, esmOpenPackage says why");
    return *package;
}
template<class Handed> Handed& required(Handed* simulation) {
    if (!simulation)
        throw InvalidModel("the simulation is NULL: it was not made, esmMakeSimulation says why");
    return *simulation;
}

Integrator namedIntegrator(const char* name) {
    if (!name) return Integrator::Auto;
    const std::optional<Integrator> integrator = integratorFromName(name);
    if (!integrator)
        throw InvalidModel(std::string("there is no integrator \"") + name + "\"; take one of " +
                           integratorNames());
    return *integrator;
}

SimulationSettings settingsOf(const EsmSettings& asked) {
    SimulationSettings settings;
    settings.integrator = namedIntegrator(asked.integrator);
    if (asked.timeStep != 0) settings.timeStep = asked.timeStep;
    settings.precision = asked.isSinglePrecision ? Precision::Float : Precision::Double;
    settings.damping = asked.dampsAxially ? Damping::Axial : Damping::Isotropic;
    settings.threads = asked.threads;
    return settings;
}

SimulationSettings chosenSettings(const EsmSettings& asked, const PackagedTissue& package) {
    const SimulationSettings settings = settingsOf(asked);
    const bool isOpen = !asked.integrator && asked.timeStep == 0 && !asked.isSinglePrecision;
    return isOpen ? steppedAsRecommended(settings, package.tissue, package.stepping) : settings;
}

EsmSimulation* makeSimulation(const EsmPackage& from, const EsmSettings& asked) {
    const std::shared_ptr<const PackagedTissue>& package = from.arrays.package();
    const SimulationSettings settings = chosenSettings(asked, *package);
    return new EsmSimulation{package, Simulation(package->tissue, settings,
                                                 touchedSurface(package->mesh, *package->tissue.network))};
}

std::size_t nodeCount(const EsmSimulation& self) {
    return self.simulation.positions().size();
}

Eigen::Vector3d vectorAt(const double* numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

int setForces(EsmSimulation& self, std::size_t count, const std::uint32_t* nodes, const double* forces) {
    std::vector<std::pair<std::uint32_t, Eigen::Vector3d>> checked;
    checked.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        checked.emplace_back(nodes[i],
                             givenVector("force", nodes[i], vectorAt(forces + 3 * i), nodeCount(self)));
    self.loads.forces = std::move(checked);
    return 1;
}

int leadNodes(EsmSimulation& self, std::size_t count, const std::uint32_t* nodes, const double* places) {
    std::vector<PrescribedNode> led;
    led.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        led.push_back({nodes[i], givenVector("place", nodes[i], vectorAt(places + 3 * i), nodeCount(self))});
    self.loads.prescribed = std::move(led);
    return 1;
}

int placeInstruments(EsmSimulation& self, std::size_t count, const EsmInstrument* instruments) {
    std::vector<PlacedCollider> placed;
    placed.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [radius, length, place, orientation] = instruments[i];
        placed.push_back(givenInstrument(i, {radius, length, vectorAt(place), std::to_array(orientation)}));
    }
    self.loads.instruments = std::move(placed);
    return 1;
}

int stepOn(EsmSimulation& self, std::size_t count, EsmError* error) {
    advancePressed(self.simulation, self.loads, self.package->pressures, count);
    report(error, self.simulation.failure());
    return 1;
}

int writeDrawnVertices(const EsmSimulation& self, double* vertices) {
    const PackagedTissue& package = *self.package;
    for (const Eigen::Vector3d& place :
         drawnPositions(package.mesh, *package.tissue.network, self.simulation.positions()))
        vertices = std::copy_n(place.data(), 3, vertices);
    return 1;
}

} // namespace

} // namespace esm

EsmSimulation* esmMakeSimulation(const EsmPackage* package, const EsmSettings* settings, EsmError* error) {
    return esm::guarded(error, static_cast<EsmSimulation*>(nullptr), [&] {
        return esm::makeSimulation(esm::required(package), settings ? *settings : EsmSettings{});
    });
}

void esmFreeSimulation(EsmSimulation* simulation) {
    delete simulation;
}

const char* esmIntegratorOf(const EsmSimulation* simulation) {
    return esm::integratorName(simulation->simulation.integrator());
}

double esmTimeStepOf(const EsmSimulation* simulation) {
    return simulation->simulation.timeStep();
}

double esmTimeOf(const EsmSimulation* simulation) {
    return simulation->simulation.time();
}

int esmSetGravity(EsmSimulation* simulation, const double gravity[3], EsmError* error) {
    return esm::guarded(error, 0, [&] {
        esm::required(simulation).loads.gravity = esm::givenGravity(esm::vectorAt(gravity));
        return 1;
    });
}

int esmSetForces(EsmSimulation* simulation, size_t count, const uint32_t* nodes, const double* forces,
                 EsmError* error) {
    return esm::guarded(error, 0,
                        [&] { return esm::setForces(esm::required(simulation), count, nodes, forces); });
}

int esmLeadNodes(EsmSimulation* simulation, size_t count, const uint32_t* nodes, const double* places,
                 EsmError* error) {
    return esm::guarded(error, 0,
                        [&] { return esm::leadNodes(esm::required(simulation), count, nodes, places); });
}

int esmPlaceInstruments(EsmSimulation* simulation, size_t count, const EsmInstrument* instruments,
                        EsmError* error) {
    return esm::guarded(error, 0,
                        [&] { return esm::placeInstruments(esm::required(simulation), count, instruments); });
}

size_t esmStep(EsmSimulation* simulation, size_t count, EsmError* error) {
    const double begin = simulation ? simulation->simulation.time() : 0;
    esm::guarded(error, 0, [&] { return esm::stepOn(esm::required(simulation), count, error); });
    if (!simulation) return 0;
    return static_cast<size_t>(
        std::llround((simulation->simulation.time() - begin) / simulation->simulation.timeStep()));
}

void esmReset(EsmSimulation* simulation) {
    simulation->loads.instruments.clear();
    esm::guarded(nullptr, 0, [&] {
        simulation->simulation.reset();
        return 1;
    });
}

const double* esmPositionsOf(const EsmSimulation* simulation) {
    return esm::numbersIn(simulation->simulation.positions());
}

const double* esmVelocitiesOf(const EsmSimulation* simulation) {
    return esm::numbersIn(simulation->simulation.velocities());
}

int esmDrawnVertices(const EsmSimulation* simulation, double* vertices, EsmError* error) {
    return esm::guarded(error, 0,
                        [&] { return esm::writeDrawnVertices(esm::required(simulation), vertices); });
}

void esmInstrumentImpulse(const EsmSimulation* simulation, size_t instrument, double impulse[3]) {
    const std::vector<esm::InstrumentTouch>& touches = simulation->simulation.instrumentTouches();
    const Eigen::Vector3d given =
        instrument < touches.size() ? touches[instrument].impulse : Eigen::Vector3d::Zero();
    std::copy_n(given.data(), 3, impulse);
}
