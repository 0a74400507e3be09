#include "core/c/esm_package.h"
#include "core/c/failure.h"
#include "core/c/package_arrays.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>

struct EsmSimulation {
    std::shared_ptr<const esm::PackagedTissue> package;
    esm::Simulation simulation;
    esm::Loads loads{};
};

namespace esm {

namespace {

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

/// Where all is left open that a recommendation would say, and the recommended step is stable.
bool takesRecommendation(const EsmSettings& asked, const PackagedTissue& package) {
    return !asked.integrator && asked.timeStep == 0 && !asked.isSinglePrecision && !asked.dampsAxially &&
           package.stepping && isStable(package.tissue, package.stepping->stepping);
}

SimulationSettings chosenSettings(const EsmSettings& asked, const PackagedTissue& package) {
    const SimulationSettings settings = settingsOf(asked);
    return takesRecommendation(asked, package) ? withStepping(settings, package.stepping->stepping)
                                               : settings;
}

EsmSimulation* makeSimulation(const EsmPackage& from, const EsmSettings& asked) {
    const std::shared_ptr<const PackagedTissue>& package = from.arrays.package();
    const SimulationSettings settings = chosenSettings(asked, *package);
    return new EsmSimulation{package, Simulation(package->tissue, settings,
                                                 touchedSurface(package->mesh, *package->tissue.network))};
}

/// A vector for one of the nodes, from a caller who may have anything there. @param what "force"
Eigen::Vector3d checkedVector(const EsmSimulation& self, const char* what, std::uint32_t node,
                              const double* numbers) {
    const std::size_t count = self.simulation.positions().size();
    if (node >= count)
        throw InvalidModel(std::string("a ") + what + " is for node " + std::to_string(node) +
                           ", but there are " + std::to_string(count));
    Eigen::Vector3d vector(numbers[0], numbers[1], numbers[2]);
    if (!vector.allFinite())
        throw InvalidModel(std::string("the ") + what + " for node " + std::to_string(node) +
                           " is not a number");
    return vector;
}

int setForces(EsmSimulation& self, std::size_t count, const std::uint32_t* nodes, const double* forces) {
    std::vector<std::pair<std::uint32_t, Eigen::Vector3d>> checked;
    checked.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        checked.emplace_back(nodes[i], checkedVector(self, "force", nodes[i], forces + 3 * i));
    self.loads.beginsAnew = self.loads.beginsAnew || checked != self.loads.forces;
    self.loads.forces = std::move(checked);
    return 1;
}

bool leadsOthers(const std::vector<PrescribedNode>& before, const std::vector<PrescribedNode>& now) {
    return !std::equal(before.begin(), before.end(), now.begin(), now.end(),
                       [](const auto& one, const auto& other) { return one.node == other.node; });
}

int leadNodes(EsmSimulation& self, std::size_t count, const std::uint32_t* nodes, const double* places) {
    std::vector<PrescribedNode> led;
    led.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        led.push_back({nodes[i], checkedVector(self, "place", nodes[i], places + 3 * i)});
    self.loads.beginsAnew = self.loads.beginsAnew || leadsOthers(self.loads.prescribed, led);
    self.loads.prescribed = std::move(led);
    return 1;
}

PlacedCollider colliderOf(const EsmInstrument& instrument) {
    const auto& [w, x, y, z] = instrument.orientation;
    const Eigen::Quaterniond turn = w == 0 && x == 0 && y == 0 && z == 0 ? Eigen::Quaterniond::Identity()
                                                                         : Eigen::Quaterniond(w, x, y, z);
    const Eigen::Vector3d place(instrument.place[0], instrument.place[1], instrument.place[2]);
    const bool hasSize = instrument.radius > 0 && std::isfinite(instrument.radius) &&
                         instrument.length >= 0 && std::isfinite(instrument.length);
    if (!hasSize || !place.allFinite() || !std::isnormal(turn.squaredNorm()))
        throw InvalidModel("an instrument has no place, no direction or no radius above 0");
    const ColliderPose pose{place, turn.normalized()};
    if (instrument.length > 0) return {Capsule{instrument.radius, instrument.length}, pose};
    return {Sphere{instrument.radius}, pose};
}

int placeInstruments(EsmSimulation& self, std::size_t count, const EsmInstrument* instruments) {
    std::vector<PlacedCollider> placed;
    placed.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        placed.push_back(colliderOf(instruments[i]));
    self.loads.instruments = std::move(placed);
    return 1;
}

/// What a change of loads begins is begun by the first step alone.
int stepOn(EsmSimulation& self, std::size_t count, EsmError* error) {
    if (self.simulation.advance(self.loads, std::min<std::size_t>(count, 1)) == 1) {
        self.loads.beginsAnew = false;
        self.simulation.advance(self.loads, count - 1);
    }
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
    return esm::guarded(error, static_cast<EsmSimulation*>(nullptr),
                        [&] { return esm::makeSimulation(*package, settings ? *settings : EsmSettings{}); });
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
        const Eigen::Vector3d asked(gravity[0], gravity[1], gravity[2]);
        if (!asked.allFinite()) throw esm::InvalidModel("gravity is not a number");
        simulation->loads.beginsAnew = simulation->loads.beginsAnew || asked != simulation->loads.gravity;
        simulation->loads.gravity = asked;
        return 1;
    });
}

int esmSetForces(EsmSimulation* simulation, size_t count, const uint32_t* nodes, const double* forces,
                 EsmError* error) {
    return esm::guarded(error, 0, [&] { return esm::setForces(*simulation, count, nodes, forces); });
}

int esmLeadNodes(EsmSimulation* simulation, size_t count, const uint32_t* nodes, const double* places,
                 EsmError* error) {
    return esm::guarded(error, 0, [&] { return esm::leadNodes(*simulation, count, nodes, places); });
}

int esmPlaceInstruments(EsmSimulation* simulation, size_t count, const EsmInstrument* instruments,
                        EsmError* error) {
    return esm::guarded(error, 0, [&] { return esm::placeInstruments(*simulation, count, instruments); });
}

size_t esmStep(EsmSimulation* simulation, size_t count, EsmError* error) {
    const double begin = simulation->simulation.time();
    esm::guarded(error, 0, [&] { return esm::stepOn(*simulation, count, error); });
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
    return esm::guarded(error, 0, [&] { return esm::writeDrawnVertices(*simulation, vertices); });
}

void esmInstrumentImpulse(const EsmSimulation* simulation, size_t instrument, double impulse[3]) {
    const std::vector<esm::InstrumentTouch>& touches = simulation->simulation.instrumentTouches();
    const Eigen::Vector3d given =
        instrument < touches.size() ? touches[instrument].impulse : Eigen::Vector3d::Zero();
    std::copy_n(given.data(), 3, impulse);
}
