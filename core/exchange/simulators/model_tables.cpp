#include "core/exchange/simulators/model_tables.h"

#include "core/exchange/tissue_json.h"

namespace esm {

namespace {

using Numbers = std::vector<double>;
using Integers = std::vector<std::int32_t>;
using Texts = std::vector<std::string>;

std::int32_t placeNumber(std::size_t place) {
    return static_cast<std::int32_t>(place);
}

Integers placeNumbers(const std::vector<std::uint32_t>& places) {
    return {places.begin(), places.end()};
}

/// What every one of many things has.
template<class Things, class Value> auto each(const Things& things, Value valueOf) {
    std::vector<std::decay_t<decltype(valueOf(*things.begin()))>> values;
    values.reserve(things.size());
    for (const auto& thing : things)
        values.push_back(valueOf(thing));
    return values;
}

TableColumn springConstants(Numbers values) {
    return {"spring_constant", "N/m", {}, std::move(values)};
}

TableColumn viscosities(Numbers values) {
    return {"viscosity", "N·s/m", {}, std::move(values)};
}

/// @param corners the nodes of one triangle, tetrahedron or line after the other
TableColumn nodesColumn(const std::vector<std::uint32_t>& corners, std::size_t cornersEach) {
    std::vector<std::string> parts;
    for (std::size_t i = 1; i <= cornersEach; ++i)
        parts.push_back("node_" + std::to_string(i));
    return {"nodes", "", parts, placeNumbers(corners)};
}

ModelTable wholeModel(const Handover& handover) {
    ModelTable table{"model",
                     {{"version", "", {}, Integers{modelTablesVersion}},
                      {"generator", "", {}, Texts{std::string("Elastodynamic Shape Modeler ") + ESM_VERSION}},
                      {"name", "", {}, Texts{handover.project.name}},
                      {"damping", "", {}, Texts{"isotropic"}}}};
    if (const auto& stiffening = handover.tissue.stiffening) {
        table.columns.push_back({"stiffening_strain", "", {}, Numbers{stiffening->strain}});
        table.columns.push_back({"stiffening_factor", "", {}, Numbers{stiffening->factor}});
    }
    if (const auto& measured = handover.project.stepping) {
        table.columns.push_back({"integrator", "", {}, Texts{integratorName(measured->stepping.integrator)}});
        table.columns.push_back({"time_step", "s", {}, Numbers{measured->stepping.timeStep}});
    }
    return table;
}

ModelTable nodesTable(const Handover& handover) {
    const TissueModel& tissue = handover.tissue;
    Integers fixed(tissue.mass.size(), 0);
    for (const std::uint32_t node : tissue.fixedNodes)
        fixed[node] = 1;
    ModelTable table{"nodes",
                     {{"rest_position", "m", {"x", "y", "z"}, coordinatesOf(tissue.network->restPositions)},
                      {"mass", "kg", {}, tissue.mass},
                      springConstants(tissue.springConstant),
                      viscosities(tissue.viscosity),
                      {"fixed", "", {}, std::move(fixed)}}};
    if (!handover.project.regions.empty())
        table.columns.push_back(
            {"region", "", {}, regionsOfNodes(*tissue.network, handover.project.regions)});
    return table;
}

ModelTable springsTable(const TissueModel& tissue) {
    const std::vector<Spring>& springs = tissue.network->springs;
    std::vector<std::uint32_t> ends;
    for (const Spring& spring : springs)
        ends.insert(ends.end(), {spring.first, spring.second});
    const std::vector<SpringValues> values = springValues(tissue);
    return {"springs",
            {nodesColumn(ends, 2),
             {"rest_length", "m", {}, each(springs, [](const Spring& spring) { return spring.restLength; })},
             springConstants(each(values, [](const SpringValues& value) { return value.springConstant; })),
             viscosities(each(values, [](const SpringValues& value) { return value.viscosity; }))}};
}

ModelTable tethersTable(const std::vector<Tether>& tethers) {
    return {"tethers",
            {{"node", "", {}, each(tethers, [](const Tether& tether) { return placeNumber(tether.node); })},
             springConstants(each(tethers, [](const Tether& tether) { return tether.springConstant; })),
             viscosities(each(tethers, [](const Tether& tether) { return tether.viscosity; }))}};
}

ModelTable hingesTable(const std::vector<Hinge>& hinges) {
    Integers nodes;
    for (const Hinge& hinge : hinges)
        nodes.insert(nodes.end(), hinge.nodes.begin(), hinge.nodes.end());
    return {
        "hinges",
        {{"nodes", "", {"edge_1", "edge_2", "corner_1", "corner_2"}, std::move(nodes)},
         {"stiffness", "N·m/rad", {}, each(hinges, [](const Hinge& hinge) { return hinge.stiffness; })},
         {"viscosity", "N·m·s/rad", {}, each(hinges, [](const Hinge& hinge) { return hinge.viscosity; })}}};
}

/// A row for each node of each vertex: however many carry it, the table has the same columns.
ModelTable bindingTable(const BindingRows& rows) {
    Integers vertices;
    vertices.reserve(rows.nodes.size());
    for (std::size_t vertex = 0; vertex < rows.size(); ++vertex)
        vertices.insert(vertices.end(), rows[vertex].nodes.size(), placeNumber(vertex));
    return {"binding",
            {{"vertex", "", {}, std::move(vertices)},
             {"node", "", {}, placeNumbers(rows.nodes)},
             {"share", "", {}, rows.shares}}};
}

ModelTable linesTable(const std::vector<Edge>& lines) {
    std::vector<std::uint32_t> ends;
    for (const auto& [first, second] : lines)
        ends.insert(ends.end(), {first, second});
    return {"lines", {nodesColumn(ends, 2)}};
}

void addFluids(const std::vector<Cavity>& cavities, std::vector<ModelTable>& tables) {
    Integers parts, partsOfTriangles;
    Numbers stiffnesses;
    std::vector<Triangle> triangles;
    for (const Cavity& cavity : cavities) {
        if (cavity.stiffness <= 0) continue; // a load's alone: loads are no part of the organ
        parts.push_back(placeNumber(cavity.part));
        stiffnesses.push_back(cavity.stiffness);
        partsOfTriangles.insert(partsOfTriangles.end(), cavity.triangles.size(), placeNumber(cavity.part));
        triangles.insert(triangles.end(), cavity.triangles.begin(), cavity.triangles.end());
    }
    tables.push_back(
        {"fillings", {{"part", "", {}, std::move(parts)}, {"stiffness", "Pa", {}, std::move(stiffnesses)}}});
    tables.push_back({"filling_triangles",
                      {{"part", "", {}, std::move(partsOfTriangles)}, nodesColumn(cornersOf(triangles), 3)}});
}

ModelTable regionsTable(const std::vector<Region>& regions) {
    Integers colours;
    for (const Region& region : regions)
        colours.insert(colours.end(), region.colour.begin(), region.colour.end());
    return {"regions",
            {{"name", "", {}, each(regions, [](const Region& region) { return region.name; })},
             {"colour", "", {"red", "green", "blue"}, std::move(colours)}}};
}

/// What carries the drawn surface where that is not each vertex by its own node.
void addCarrying(const Handover& handover, std::vector<ModelTable>& tables) {
    const SpringNetwork& network = *handover.tissue.network;
    tables.push_back({"vertices", {{"node", "", {}, placeNumbers(network.vertexNodes)}}});
    if (!network.binding) return;
    tables.push_back(bindingTable(network.binding->vertices));
    tables.push_back({"simulated_triangles",
                      {nodesColumn(cornersOf(simulatedSurface(*handover.project.mesh, network)), 3)}});
    tables.push_back(linesTable(network.binding->lines));
}

} // namespace

std::size_t rowCount(const TableColumn& column) {
    return std::visit([&](const auto& values) { return values.size() / partsOf(column); }, column.values);
}

std::vector<std::int32_t> regionsOfNodes(const SpringNetwork& network, const std::vector<Region>& regions) {
    std::vector<std::int32_t> numbers(network.restPositions.size(), -1);
    for (std::size_t region = 0; region < regions.size(); ++region) {
        const std::vector<double> weights = nodeWeights(network, regions[region]);
        for (std::size_t node = 0; node < weights.size(); ++node)
            if (weights[node] >= 0.5) numbers[node] = placeNumber(region);
    }
    return numbers;
}

std::vector<ModelTable> modelTables(const Handover& handover) {
    const TissueModel& tissue = handover.tissue;
    std::vector<ModelTable> tables;
    tables.push_back(wholeModel(handover));
    tables.push_back(nodesTable(handover));
    tables.push_back(springsTable(tissue));
    tables.push_back(tethersTable(tissue.tethers));
    tables.push_back(hingesTable(tissue.hinges));
    tables.push_back(regionsTable(handover.project.regions));
    addCarrying(handover, tables);
    if (const auto& lattice = tissue.network->lattice)
        tables.push_back({"tetrahedra", {nodesColumn(cornersOf(lattice->tetrahedra), 4)}});
    addFluids(tissue.cavities, tables);
    std::erase_if(tables, [](const ModelTable& table) { return rowCount(table.columns.front()) == 0; });
    return tables;
}

} // namespace esm
