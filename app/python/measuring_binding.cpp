#include "app/python/bindings.h"
#include "app/python/choices.h"
#include "app/python/scene_argument.h"
#include "app/python/tissue.h"
#include "core/dynamics/measure/tradeoff.h"
#include "core/support/errors.h"

#include <pybind11/stl.h>

namespace esm::python {

namespace py = pybind11;

namespace {

py::dict runInPython(const TradeoffRun& run) {
    py::dict entry = dictionaryOf(run.stepping);
    entry["stable"] = run.stable;
    entry["error"] = run.stable ? py::object(py::float_(run.error)) : py::none();
    entry["error_is_bound"] = run.isErrorBound;
    entry["wall_per_simulated_s"] = run.wallPerSimulatedSecond;
    return entry;
}

py::dict inPython(const Tradeoff& tradeoff) {
    py::list runs, pareto;
    for (const TradeoffRun& run : tradeoff.runs)
        runs.append(runInPython(run));
    for (const std::size_t place : tradeoff.pareto)
        pareto.append(runs[place]);
    const auto chosen = [&](const std::optional<std::size_t>& place) -> py::object {
        return place ? py::object(runs[*place]) : py::none();
    };
    py::dict reference = dictionaryOf(tradeoff.reference.stepping), recommended, result;
    reference["estimated_error"] = tradeoff.reference.estimatedError;
    recommended["real_time"] = chosen(tradeoff.bestInRealTime);
    recommended["max_error"] = chosen(tradeoff.fastestToError);
    result["reference"] = reference;
    result["runs"] = runs;
    result["pareto"] = pareto;
    result["recommended"] = recommended;
    return result;
}

/// What holds tissue was evaluated with it; a scene that says another thing would be followed by half.
Scene loadsFor(const Tissue& tissue, const py::object& given) {
    Scene scene = sceneFrom(given);
    std::vector<std::string> problems = validate(scene, tissue.nodeCount());
    if (!scene.fixed.empty() || !scene.tethers.empty() || !scene.fillings.empty())
        problems.emplace_back(
            "fixed nodes, tethers and fillings are the tissue's: evaluate the project with them, and "
            "leave them out of the scene that is measured");
    if (!problems.empty()) throw InvalidModel(std::move(problems));
    return scene;
}

/// Ctrl-C cancels.
bool goesOn(double) {
    const py::gil_scoped_acquire python;
    return PyErr_CheckSignals() == 0;
}

py::dict measured(const Tissue& tissue, const py::object& given, const TradeoffOptions& options) {
    const Scene scene = loadsFor(tissue, given);
    const TouchedSurface surface = touchedSurface(*tissue.mesh, *tissue.model->network);
    const auto found = [&] {
        const py::gil_scoped_release others;
        return measureTradeoff({*tissue.model, surface, scene}, options, goesOn);
    }();
    return inPython(found);
}

} // namespace

void addMeasuring(py::module_& module) {
    module.def(
        "measure",
        [](const Tissue& tissue, const py::object& scene, double maxError, double realTime, double maxSeconds,
           const std::string& damping) {
            TradeoffOptions options;
            options.wishes = {realTime, maxError};
            options.mostSecondsPerRun = maxSeconds;
            options.damping = chosenDamping(damping);
            return measured(tissue, scene, options);
        },
        py::arg("tissue"), py::arg("scene"), py::arg("max_error") = 0.01, py::arg("real_time") = 1.0,
        py::arg("max_seconds") = 10.0, py::arg("damping") = "isotropic",
        R"(Error and cost of every integrator over steps and precisions, as `esmc tradeoff` measures them.

scene: a dictionary with the keys of a scene file; what it moves is compared. max_error: wanted at most, relative to the
motion. real_time: times real time wanted at least. max_seconds: what would compute for longer is left out.
Gives a dictionary: reference, runs, pareto (those that none beats) and recommended (real_time, max_error; None where
nothing reaches it). Takes minutes; Ctrl-C ends it.)");
}

} // namespace esm::python
