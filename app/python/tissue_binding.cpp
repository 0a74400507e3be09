#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/tissue.h"
#include "core/model/lattice.h"

#include <pybind11/stl/filesystem.h>

namespace esm::python {

namespace {

using TissueClass = py::class_<Tissue, std::shared_ptr<Tissue>>;

/// A property whose array shares the tissue's memory. @param array makes it, given the tissue and its object
template<class MakeArray>
void addArray(TissueClass& type, const char* name, const char* doc, const MakeArray& array) {
    type.def_property_readonly(
        name, [array](const py::object& self) { return py::object(array(self.cast<const Tissue&>(), self)); },
        doc);
}

void addNodes(TissueClass& type) {
    addArray(type, "rest_positions", "m, shape (nodes, 3)", [](const Tissue& tissue, py::handle self) {
        return sharedRows(tissue.model->network->restPositions, self);
    });
    addArray(type, "masses", "kg, shape (nodes,)",
             [](const Tissue& tissue, py::handle self) { return sharedNumbers(tissue.model->mass, self); });
    addArray(type, "node_spring_constants", "N/m, shape (nodes,): the tissue's at each node",
             [](const Tissue& tissue, py::handle self) {
                 return sharedNumbers(tissue.model->springConstant, self);
             });
    addArray(
        type, "node_viscosities", "N·s/m, shape (nodes,): the tissue's at each node",
        [](const Tissue& tissue, py::handle self) { return sharedNumbers(tissue.model->viscosity, self); });
    addArray(type, "fixed_nodes", "shape (fixed,), ascending", [](const Tissue& tissue, py::handle self) {
        return sharedNumbers(tissue.model->fixedNodes, self);
    });
}

void addSprings(TissueClass& type) {
    addArray(type, "springs", "both ends of each, shape (springs, 2)",
             [](const Tissue& tissue, py::handle self) {
                 const auto& springs = tissue.model->network->springs;
                 return sharedMember(springs, &Spring::first, 2, self);
             });
    addArray(type, "rest_lengths", "m, shape (springs,)", [](const Tissue& tissue, py::handle self) {
        const auto& springs = tissue.model->network->springs;
        return sharedMember(springs, &Spring::restLength, 1, self);
    });
    addArray(type, "spring_constants", "N/m, shape (springs,)", [](const Tissue& tissue, py::handle self) {
        return sharedMember(tissue.springValues, &SpringValues::springConstant, 1, self);
    });
    addArray(type, "viscosities", "N·s/m, shape (springs,)", [](const Tissue& tissue, py::handle self) {
        return sharedMember(tissue.springValues, &SpringValues::viscosity, 1, self);
    });
    type.def_property_readonly(
        "stiffening",
        [](const Tissue& tissue) -> py::object {
            const auto& law = tissue.model->stiffening;
            return law ? py::object(py::make_tuple(law->strain, law->factor)) : py::none();
        },
        "(strain, factor) of biphasic springs; None where springs are linear");
}

void addTethers(TissueClass& type) {
    addArray(type, "tether_nodes", "shape (tethers,)", [](const Tissue& tissue, py::handle self) {
        const auto& tethers = tissue.model->tethers;
        return sharedMember(tethers, &Tether::node, 1, self);
    });
    addArray(type, "tether_spring_constants", "N/m, shape (tethers,)",
             [](const Tissue& tissue, py::handle self) {
                 const auto& tethers = tissue.model->tethers;
                 return sharedMember(tethers, &Tether::springConstant, 1, self);
             });
    addArray(type, "tether_viscosities", "N·s/m, shape (tethers,)",
             [](const Tissue& tissue, py::handle self) {
                 const auto& tethers = tissue.model->tethers;
                 return sharedMember(tethers, &Tether::viscosity, 1, self);
             });
}

void addHinges(TissueClass& type) {
    addArray(type, "hinges", "both ends of the edge, then the corner on either side: shape (hinges, 4)",
             [](const Tissue& tissue, py::handle self) {
                 const auto& hinges = tissue.model->hinges;
                 return sharedArray(hinges.empty() ? nullptr : hinges.front().nodes.data(),
                                    {hinges.size(), 4, sizeof(Hinge)}, self);
             });
    addArray(type, "hinge_stiffnesses", "N·m for each radian, shape (hinges,)",
             [](const Tissue& tissue, py::handle self) {
                 const auto& hinges = tissue.model->hinges;
                 return sharedMember(hinges, &Hinge::stiffness, 1, self);
             });
    addArray(type, "hinge_viscosities", "N·m·s for each radian, shape (hinges,)",
             [](const Tissue& tissue, py::handle self) {
                 const auto& hinges = tissue.model->hinges;
                 return sharedMember(hinges, &Hinge::viscosity, 1, self);
             });
}

void addSurface(TissueClass& type) {
    addArray(type, "vertices", "of the drawn surface at rest, m, shape (vertices, 3)",
             [](const Tissue& tissue, py::handle self) { return sharedRows(tissue.mesh->vertices, self); });
    addArray(type, "triangles", "vertices, counter-clockwise seen from outside: shape (triangles, 3)",
             [](const Tissue& tissue, py::handle self) { return sharedRows(tissue.mesh->triangles, self); });
    addArray(type, "vertex_nodes", "the node that carries each vertex, or most of it: shape (vertices,)",
             [](const Tissue& tissue, py::handle self) {
                 return sharedNumbers(tissue.model->network->vertexNodes, self);
             });
    type.def_property_readonly(
        "binding",
        [](const py::object& self) -> py::object {
            const auto& binding = self.cast<const Tissue&>().model->network->binding;
            if (!binding) return py::none();
            const BindingRows& rows = binding->vertices;
            return py::make_tuple(sharedNumbers(rows.starts, self), sharedNumbers(rows.nodes, self),
                                  sharedNumbers(rows.shares, self));
        },
        "(starts, nodes, shares) of the nodes that carry each vertex, as rows of a compressed sparse matrix; "
        "None where each vertex keeps its place at its node");
    addArray(type, "tetrahedra", "nodes, of what fills a solid organ: shape (tetrahedra, 4)",
             [](const Tissue& tissue, py::handle self) {
                 static const std::vector<Tetrahedron> none;
                 const auto& lattice = tissue.model->network->lattice;
                 return sharedRows(lattice ? lattice->tetrahedra : none, self);
             });
}

py::object steppingOf(const Tissue& tissue) {
    if (!tissue.stepping) return py::none();
    py::dict entry = dictionaryOf(tissue.stepping->stepping);
    entry["error"] = tissue.stepping->error;
    entry["wall_per_simulated_s"] = tissue.stepping->wallPerSimulatedSecond;
    return entry;
}

} // namespace

py::dict dictionaryOf(const Stepping& stepping) {
    py::dict entry;
    entry["integrator"] = integratorName(stepping.integrator);
    entry["dt"] = stepping.timeStep;
    entry["precision"] = wordOf(stepping.precision);
    return entry;
}

Tissue tissueOf(PackagedTissue package) {
    const auto model = std::make_shared<const TissueModel>(std::move(package.tissue));
    return {std::move(package.name),
            model,
            std::make_shared<const TriangleMesh>(std::move(package.mesh)),
            springValues(*model),
            std::move(package.stepping),
            std::move(package.pressures)};
}

void addTissue(py::module_& module) {
    TissueClass type(
        module, "Tissue",
        "What moves of an organ, and the surface that it carries. Arrays share the tissue's memory "
        "and cannot be written to.");
    type.def_readonly("name", &Tissue::name);
    addNodes(type);
    addSprings(type);
    addTethers(type);
    addHinges(type);
    addSurface(type);
    type.def_property_readonly(
        "stepping", steppingOf,
        "How its maker measured it to be stepped best, a dictionary: integrator, dt (s), "
        "precision, error (relative to the motion), wall_per_simulated_s (on the machine "
        "that measured). None where nothing was measured.");
    module.def(
        "load_package", [](const std::filesystem::path& file) { return tissueOf(loadPackagedTissue(file)); },
        py::arg("file"), "The Tissue of a model package (.glb). Raises OSError for one that is damaged.");
}

} // namespace esm::python
