#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/choices.h"
#include "app/python/tissue.h"
#include "core/dynamics/given_loads.h"
#include "core/dynamics/measure/scene_loads.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "core/support/errors.h"

#include <pybind11/stl.h>

namespace esm::python {

namespace {

/// A flag that is set for as long as this lives.
class SetWhile {
public:
    explicit SetWhile(bool& flag) : m_flag(flag) { m_flag = true; }
    SetWhile(const SetWhile&) = delete;
    SetWhile& operator=(const SetWhile&) = delete;
    ~SetWhile() { m_flag = false; }

private:
    bool& m_flag;
};

/// A run, with what it moves. Python's lock is let go while it steps; whatever else is asked of it by then
/// would meet a half-made state, and is refused.
class Run {
public:
    Run(std::shared_ptr<const Tissue> tissue, const SimulationSettings& settings)
        : m_tissue(std::move(tissue)),
          m_simulation(*m_tissue->model, settings,
                       touchedSurface(*m_tissue->mesh, *m_tissue->model->network)) {}

    const Simulation& simulation() const {
        requireStill();
        return m_simulation;
    }
    const std::shared_ptr<const Tissue>& tissue() const { return m_tissue; }
    std::size_t nodeCount() const { return m_tissue->nodeCount(); }

    void setForces(const py::object& nodes, const Vectors3& forces) {
        auto given = vectorsByNode("force", nodes, forces, nodeCount()); // may let other threads run
        requireStill();
        m_loads.forces = std::move(given);
    }
    void lead(const py::object& nodes, const Vectors3& places) {
        const auto given = vectorsByNode("place", nodes, places, nodeCount()); // may let other threads run
        requireStill();
        m_loads.prescribed.clear();
        for (const auto& [node, place] : given)
            m_loads.prescribed.push_back({node, place});
    }
    void setGravity(const std::array<double, 3>& gravity) {
        requireStill();
        m_loads.gravity = givenGravity({gravity[0], gravity[1], gravity[2]});
    }
    std::array<double, 3> gravity() const {
        requireStill();
        return {m_loads.gravity.x(), m_loads.gravity.y(), m_loads.gravity.z()};
    }

    void placeInstruments(const std::vector<GivenInstrument>& instruments) {
        requireStill();
        std::vector<PlacedCollider> placed;
        placed.reserve(instruments.size());
        for (const GivenInstrument& instrument : instruments)
            placed.push_back(givenInstrument(placed.size(), instrument));
        m_loads.instruments = std::move(placed);
    }
    py::array_t<double> impulse(std::size_t instrument) const {
        const std::vector<InstrumentTouch>& touches = simulation().instrumentTouches();
        const Eigen::Vector3d given =
            instrument < touches.size() ? touches[instrument].impulse : Eigen::Vector3d(0, 0, 0);
        return py::array_t<double>(3, given.data());
    }

    /// In parts that are short enough for Ctrl-C.
    void step(std::int64_t count) {
        requireStill();
        if (count < 0)
            throw InvalidModel("the number of steps must be 0 or more, not " + std::to_string(count));
        constexpr std::size_t mostTogether = 64;
        for (auto left = static_cast<std::size_t>(count); left > 0;) {
            left -= taken(std::min(left, mostTogether));
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        }
    }

    py::array_t<double> vertices() const {
        return copiedPoints(
            drawnPositions(*m_tissue->mesh, *m_tissue->model->network, simulation().positions()));
    }
    void reset() {
        requireStill();
        m_loads.instruments.clear();
        m_simulation.reset();
    }

private:
    void requireStill() const {
        if (m_isStepping)
            throw InvalidModel(
                "another thread steps this simulation; wait for it, or make one for each thread");
    }

    std::size_t taken(std::size_t wanted) {
        const std::size_t steps = [&] {
            const SetWhile stepping(m_isStepping);
            const py::gil_scoped_release others;
            return advancePressed(m_simulation, m_loads, m_tissue->pressures, wanted);
        }();
        if (steps == wanted) return steps;
        PyErr_SetString(PyExc_ArithmeticError, m_simulation.failure().c_str());
        throw py::error_already_set();
    }

    std::shared_ptr<const Tissue> m_tissue;
    Simulation m_simulation;
    Loads m_loads;
    bool m_isStepping = false; ///< written and read under Python's lock alone
};

/// As Python names them; what is left open is recommended by the tissue, or chosen.
struct AskedSettings {
    std::optional<std::string> integrator;
    std::optional<double> timeStep;
    std::optional<std::string> precision;
    std::string damping;
    std::size_t threads;
};

SimulationSettings settingsFrom(const AskedSettings& asked, const Tissue& tissue) {
    SimulationSettings settings;
    if (asked.integrator) settings.integrator = chosenIntegrator(*asked.integrator);
    settings.timeStep = asked.timeStep;
    if (asked.precision) settings.precision = chosenPrecision(*asked.precision);
    settings.damping = chosenDamping(asked.damping);
    settings.threads = asked.threads;
    const bool isOpen = !asked.integrator && !asked.timeStep && !asked.precision;
    return isOpen ? steppedAsRecommended(settings, *tissue.model, tissue.stepping) : settings;
}

std::unique_ptr<Run> madeRun(std::shared_ptr<const Tissue> tissue, std::optional<std::string> integrator,
                             std::optional<double> timeStep, std::optional<std::string> precision,
                             const std::string& damping, std::size_t threads) {
    const AskedSettings asked{std::move(integrator), timeStep, std::move(precision), damping, threads};
    const py::gil_scoped_release others;
    const SimulationSettings settings = settingsFrom(asked, *tissue);
    return std::make_unique<Run>(std::move(tissue), settings);
}

void addInstruments(py::module_& module, py::class_<Run>& type) {
    using Triple = std::array<double, 3>;
    py::class_<GivenInstrument>(module, "Instrument",
                                "A rigid shape that pushes the surface: all that lies within the radius of a "
                                "segment along its own z.")
        .def(py::init(
                 [](double radius, const Triple& place, double length, const std::array<double, 4>& turn) {
                     return GivenInstrument{radius, length, {place[0], place[1], place[2]}, turn};
                 }),
             py::arg("radius"), py::arg("place"), py::arg("length") = 0,
             py::arg("orientation") = std::array<double, 4>{1, 0, 0, 0},
             "radius: m. place: m, of the segment's middle. length: m, of the segment; 0: a sphere. "
             "orientation: quaternion w, x, y, z from its axes to the model's.");
    type.def(
        "place_instruments", &Run::placeInstruments, py::arg("instruments"),
        "Where all instruments are at the end of the next step, each the same one by its place in the list; "
        "a new one appears where it is.");
    type.def(
        "instrument_impulse", &Run::impulse, py::arg("instrument") = 0,
        "N·s, of the tissue on an instrument since the start: over time, the mean force. Zero without such "
        "an instrument.");
}

void addLoads(py::class_<Run>& type) {
    type.def("set_forces", &Run::setForces, py::arg("nodes"), py::arg("forces"),
             "In place of all forces before: N, a row for each of the nodes, which are whole numbers, "
             "counted from 0. They act until they are set anew.");
    type.def("lead", &Run::lead, py::arg("nodes"), py::arg("positions"),
             "In place of all led nodes before, which are whole numbers, counted from 0: m, where each is at "
             "the end of the next step, and stays.");
    type.def_property("gravity", &Run::gravity, &Run::setGravity, "m/s²");
}

} // namespace

void addSimulation(py::module_& module) {
    py::class_<Run> type(module, "Simulation",
                         "Tissue that moves, from rest, under the pressures from within that it has. One "
                         "thread at a time: while one steps it, all else raises "
                         "ValueError.");
    type.def(py::init(&madeRun), py::arg("tissue"), py::arg("integrator") = py::none(),
             py::arg("time_step") = py::none(), py::arg("precision") = py::none(),
             py::arg("damping") = "isotropic", py::arg("threads") = 0,
             "integrator: 'auto', or one by name. time_step: s, chosen safely without one. precision: "
             "'double', or 'float' with an explicit integrator. Without these three it is stepped as the "
             "tissue's maker recommends, where that is stable. "
             "damping: 'isotropic' or 'axial'. threads: at most; 0: as many as the tissue is worth.");
    addLoads(type);
    addInstruments(module, type);
    type.def("step", &Run::step, py::arg("count") = 1,
             "Moves on by so many steps. Raises ArithmeticError where the motion ran wild; the last good "
             "state stays.");
    type.def("reset", &Run::reset, "Back to rest at time 0; loads stay, instruments are away.");
    type.def(
        "positions", [](const Run& run) { return copiedPoints(run.simulation().positions()); },
        "m, shape (nodes, 3): a copy");
    type.def(
        "velocities", [](const Run& run) { return copiedPoints(run.simulation().velocities()); },
        "m/s, shape (nodes, 3): a copy");
    type.def("vertices", &Run::vertices, "Where the nodes carry the drawn surface: m, shape (vertices, 3)");
    type.def_property_readonly("tissue",
                               [](const Run& run) { return std::const_pointer_cast<Tissue>(run.tissue()); });
    type.def_property_readonly(
        "time", [](const Run& run) { return run.simulation().time(); }, "s");
    type.def_property_readonly(
        "time_step", [](const Run& run) { return run.simulation().timeStep(); }, "s");
    type.def_property_readonly("integrator",
                               [](const Run& run) { return integratorName(run.simulation().integrator()); });
}

} // namespace esm::python
