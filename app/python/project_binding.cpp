#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/scene_argument.h"
#include "app/python/tissue.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/scene_file.h"
#include "core/support/errors.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace esm::python {

namespace {

using Json = nlohmann::ordered_json;

py::object pythonOf(const Json& json) {
    return py::module_::import("json").attr("loads")(json.dump());
}

Scene sceneOr(const py::object& given, const Project& project) {
    if (given.is_none()) return project.scene;
    Scene scene = sceneFrom(given);
    if (auto problems = validate(scene, project.network->restPositions.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
    return scene;
}

Tissue evaluated(const Project& project, const py::object& scene) {
    Scene held = sceneOr(scene, project);
    const auto model = std::make_shared<const TissueModel>(evaluateModel(project, held));
    return {
        project.name, model, project.mesh, springValues(*model), project.stepping, std::move(held.pressures)};
}

py::list regionsOf(const Project& project) {
    py::list regions;
    for (const Region& region : project.regions) {
        const RegionResult result = evaluateRegion(project, region);
        py::dict entry;
        entry["name"] = region.name;
        entry["nodes"] = result.nodes;
        entry["springs"] = result.springs;
        entry["weights"] = nodeWeights(*project.network, region);
        regions.append(entry);
    }
    return regions;
}

} // namespace

Scene sceneFrom(const py::object& given) {
    const py::object object =
        py::isinstance<py::str>(given)
            ? given
            : py::module_::import("json").attr("dumps")(given, py::arg("allow_nan") = false);
    const auto text = object.cast<std::string>();
    return sceneFromJson(parseJson(text.data(), text.data() + text.size()));
}

void addProject(py::module_& module) {
    py::class_<Project, std::shared_ptr<Project>> type(
        module, "Project",
        "An organ as it is authored (.esm). Arrays share its memory and cannot be written to.");
    type.def_readonly("name", &Project::name);
    type.def_property_readonly(
        "vertices",
        [](const py::object& self) { return sharedRows(self.cast<const Project&>().mesh->vertices, self); },
        "of the drawn surface at rest, m, shape (vertices, 3)");
    type.def_property_readonly(
        "triangles",
        [](const py::object& self) { return sharedRows(self.cast<const Project&>().mesh->triangles, self); },
        "vertices, counter-clockwise seen from outside: shape (triangles, 3)");
    type.def_property_readonly(
        "scene", [](const Project& project) { return pythonOf(toJson(project.scene)); },
        "What holds and moves the organ, as a dictionary with the keys of a scene file");
    type.def_property_readonly("regions", regionsOf,
                               "A dictionary for each: name, how many nodes and springs lie wholly inside, "
                               "and every node's weight, 0 to 1");
    type.def("evaluate", evaluated, py::arg("scene") = py::none(),
             "The Tissue that the regions come to, held as a scene says, or as the project's own does.");
    module.def(
        "load_project", [](const std::filesystem::path& file) { return loadProject(file); }, py::arg("file"),
        "A Project. Raises OSError for one that is damaged.");
}

} // namespace esm::python
