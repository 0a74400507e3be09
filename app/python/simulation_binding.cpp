#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/choices.h"
#include "app/python/tissue.h"
#include "core/dynamics/simulation.h"
#include "core/support/errors.h"

#include <pybind11/stl.h>

namespace esm::python {

namespace {

/// A run, with what it moves.
class Run {
public:
    Run(std::shared_ptr<const Tissue> tissue, const SimulationSettings& settings)
        : m_tissue(std::move(tissue)),
          m_simulation(*m_tissue->model, settings,
                       touchedSurface(*m_tissue->mesh, *m_tissue->model->network)) {}

    const Simulation& simulation() const { return m_simulation; }
    const std::shared_ptr<const Tissue>& tissue() const { return m_tissue; }
    std::size_t nodeCount() const { return m_tissue->nodeCount(); }

    void setForces(const NodeNumbers& nodes, const Vectors3& forces) {
        m_loads.forces = vectorsByNode("force", nodes, forces, nodeCount());
        m_loads.beginsAnew = true;
    }
    void lead(const NodeNumbers& nodes, const Vectors3& places) {
        m_loads.prescribed.clear();
        for (const auto& [node, place] : vectorsByNode("place", nodes, places, nodeCount()))
            m_loads.prescribed.push_back({node, place});
    }
    void setGravity(const std::array<double, 3>& gravity) {
        const Eigen::Vector3d asked(gravity[0], gravity[1], gravity[2]);
        if (!asked.allFinite()) throw InvalidModel("gravity is not a number");
        m_loads.gravity = asked;
        m_loads.beginsAnew = true;
    }
    std::array<double, 3> gravity() const {
        return {m_loads.gravity.x(), m_loads.gravity.y(), m_loads.gravity.z()};
    }

    /// In parts that are short enough for Ctrl-C.
    void step(std::size_t count) {
        constexpr std::size_t mostTogether = 64;
        while (count > 0) {
            const std::size_t wanted = m_loads.beginsAnew ? 1 : std::min(count, mostTogether);
            count -= taken(wanted);
            m_loads.beginsAnew = false;
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        }
    }

    py::array_t<double> vertices() const {
        return copiedPoints(
            drawnPositions(*m_tissue->mesh, *m_tissue->model->network, m_simulation.positions()));
    }
    void reset() { m_simulation.reset(); }

private:
    std::size_t taken(std::size_t wanted) {
        const std::size_t steps = [&] {
            const py::gil_scoped_release others;
            return m_simulation.advance(m_loads, wanted);
        }();
        if (steps == wanted) return steps;
        PyErr_SetString(PyExc_ArithmeticError, m_simulation.failure().c_str());
        throw py::error_already_set();
    }

    std::shared_ptr<const Tissue> m_tissue;
    Simulation m_simulation;
    Loads m_loads;
};

/// As Python names them.
struct AskedSettings {
    std::string integrator;
    std::optional<double> timeStep;
    std::string precision, damping;
    std::size_t threads;
};

SimulationSettings settingsFrom(const AskedSettings& asked) {
    SimulationSettings settings;
    settings.integrator = chosenIntegrator(asked.integrator);
    settings.timeStep = asked.timeStep;
    settings.precision = chosenPrecision(asked.precision);
    settings.damping = chosenDamping(asked.damping);
    settings.threads = asked.threads;
    return settings;
}

std::unique_ptr<Run> madeRun(std::shared_ptr<const Tissue> tissue, const std::string& integrator,
                             std::optional<double> timeStep, const std::string& precision,
                             const std::string& damping, std::size_t threads) {
    const SimulationSettings settings = settingsFrom({integrator, timeStep, precision, damping, threads});
    const py::gil_scoped_release others;
    return std::make_unique<Run>(std::move(tissue), settings);
}

void addLoads(py::class_<Run>& type) {
    type.def(
        "set_forces", &Run::setForces, py::arg("nodes"), py::arg("forces"),
        "In place of all forces before: N, a row for each of the nodes. They act until they are set anew.");
    type.def("lead", &Run::lead, py::arg("nodes"), py::arg("positions"),
             "In place of all led nodes before: m, where each is at the end of the next step, and stays.");
    type.def_property("gravity", &Run::gravity, &Run::setGravity, "m/s²");
}

} // namespace

void addSimulation(py::module_& module) {
    py::class_<Run> type(module, "Simulation", "Tissue that moves, from rest.");
    type.def(py::init(&madeRun), py::arg("tissue"), py::arg("integrator") = "auto",
             py::arg("time_step") = py::none(), py::arg("precision") = "double",
             py::arg("damping") = "isotropic", py::arg("threads") = 0,
             "time_step: s, chosen safely without one. precision: 'double', or 'float' with an explicit "
             "integrator. "
             "damping: 'isotropic' or 'axial'. threads: at most; 0: as many as the tissue is worth.");
    addLoads(type);
    type.def("step", &Run::step, py::arg("count") = 1,
             "Moves on by so many steps. Raises ArithmeticError where the motion ran wild; the last good "
             "state stays.");
    type.def("reset", &Run::reset, "Back to rest at time 0; loads stay.");
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
