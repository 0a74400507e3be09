#include "core/exchange/simulators/vtk_content.h"

#include "core/exchange/simulators/model_tables.h"
#include "core/exchange/tissue_json.h"

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

/// Every node is a point, and so is every drawn vertex that is not at its node.
struct VtkPoints {
    std::vector<Eigen::Vector3d> places;   ///< m
    std::vector<std::int64_t> nodes;       ///< by point, the node that it is or that carries most of it
    std::vector<std::uint32_t> ofVertices; ///< by vertex, its point
    std::vector<std::uint32_t> apart;      ///< the vertices that are points of their own, in their order
};

VtkPoints pointsOf(const TriangleMesh& mesh, const SpringNetwork& network) {
    VtkPoints points{network.restPositions, std::vector<std::int64_t>(network.restPositions.size()), {}, {}};
    std::iota(points.nodes.begin(), points.nodes.end(), std::int64_t{0});
    for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const std::uint32_t node = network.vertexNodes[vertex];
        const bool isAtNode = mesh.vertices[vertex] == network.restPositions[node];
        points.ofVertices.push_back(isAtNode ? node : static_cast<std::uint32_t>(points.places.size()));
        if (isAtNode) continue;
        points.places.push_back(mesh.vertices[vertex]);
        points.nodes.push_back(node);
        points.apart.push_back(vertex);
    }
    return points;
}

/// The tissue at the points.
struct VtkTissue {
    std::vector<double> springConstant, viscosity; ///< N/m, N·s/m
};

/// What nodes have; a vertex apart takes it from the nodes that carry it.
std::vector<double> carriedBy(const SpringNetwork& network, const VtkPoints& points,
                              const std::vector<double>& ofNodes) {
    std::vector<double> values = ofNodes;
    for (const std::uint32_t vertex : points.apart) {
        double value = ofNodes[network.vertexNodes[vertex]];
        if (network.binding) {
            const auto& [nodes, shares] = network.binding->vertices[vertex];
            value = 0;
            for (std::size_t i = 0; i < nodes.size(); ++i)
                value += shares[i] * ofNodes[nodes[i]];
        }
        values.push_back(value);
    }
    return values;
}

template<class Corners> void addCell(const Corners& corners, VtkCells& cells) {
    cells.points.insert(cells.points.end(), corners.begin(), corners.end());
    cells.ends.push_back(static_cast<std::int64_t>(cells.points.size()));
}

void addCells(const Handover& handover, const VtkPoints& points, VtkVolumes volumes, VtkContent& content) {
    const SpringNetwork& network = *handover.tissue.network;
    const TriangleMesh& mesh = *handover.project.mesh;
    for (const Spring& spring : network.springs)
        addCell(std::array{spring.first, spring.second}, content.lines);
    for (const auto& [first, second, third] : mesh.triangles)
        addCell(std::array{points.ofVertices[first], points.ofVertices[second], points.ofVertices[third]},
                content.triangles);
    if (network.lattice && volumes == VtkVolumes::Yes)
        for (const Tetrahedron& tetrahedron : network.lattice->tetrahedra)
            addCell(tetrahedron, content.tetrahedra);
    if (!network.springs.empty() || !mesh.triangles.empty()) return;
    for (std::uint32_t node = 0; node < network.restPositions.size(); ++node)
        addCell(std::array{node}, content.single);
}

/// Masses and tethers are the nodes' alone, so that sums over all points stay right.
void addPointArrays(const TissueModel& tissue, const VtkPoints& points, const VtkTissue& ofPoints,
                    VtkContent& content) {
    std::vector<double> mass = tissue.mass;
    mass.resize(points.places.size(), 0);
    std::vector<double> tetherConstant(mass.size(), 0), tetherViscosity = tetherConstant;
    for (const Tether& tether : tissue.tethers) {
        tetherConstant[tether.node] += tether.springConstant;
        tetherViscosity[tether.node] += tether.viscosity;
    }
    std::vector<std::uint8_t> fixed(mass.size(), 0);
    for (const std::uint32_t node : tissue.fixedNodes)
        fixed[node] = 1;
    content.ofPoints = {{"mass", "kg", 1, std::move(mass)},
                        {"spring_constant", "N/m", 1, ofPoints.springConstant},
                        {"viscosity", "N·s/m", 1, ofPoints.viscosity},
                        {"tether_spring_constant", "N/m", 1, std::move(tetherConstant)},
                        {"tether_viscosity", "N·s/m", 1, std::move(tetherViscosity)},
                        {"fixed", "", 1, std::move(fixed)},
                        {"node", "", 1, points.nodes}};
}

void addRegions(const Handover& handover, const VtkPoints& points, VtkContent& content) {
    const std::vector<std::int32_t> ofNodes =
        regionsOfNodes(*handover.tissue.network, handover.project.regions);
    std::vector<std::int32_t> regions;
    for (const std::int64_t node : points.nodes)
        regions.push_back(ofNodes[static_cast<std::size_t>(node)]);
    content.ofPoints.push_back({"region", "", 1, std::move(regions)});
}

/// The mean of the corners of each cell.
void addMeans(const VtkCells& cells, const std::vector<double>& ofPoints, std::vector<double>& values) {
    auto corner = cells.points.begin();
    for (const std::int64_t end : cells.ends) {
        const auto first = corner;
        double sum = 0;
        for (; corner != cells.points.begin() + end; ++corner)
            sum += ofPoints[static_cast<std::size_t>(*corner)];
        values.push_back(sum / static_cast<double>(corner - first));
    }
}

/// What springs have, and all other cells on the mean of their corners.
std::vector<double> ofAllCells(const VtkContent& content, const std::vector<double>& ofSprings,
                               const std::vector<double>& ofPoints) {
    std::vector<double> values;
    addMeans(content.single, ofPoints, values);
    values.insert(values.end(), ofSprings.begin(), ofSprings.end());
    addMeans(content.triangles, ofPoints, values);
    addMeans(content.tetrahedra, ofPoints, values);
    return values;
}

/// By the number of their corners: so a threshold shows springs or tetrahedra alone.
std::vector<std::uint8_t> cornerCounts(const VtkContent& content) {
    std::vector<std::uint8_t> counts;
    for (const auto& [cells, corners] : {std::pair{&content.single, 1},
                                         {&content.lines, 2},
                                         {&content.triangles, 3},
                                         {&content.tetrahedra, 4}})
        counts.insert(counts.end(), cells->ends.size(), static_cast<std::uint8_t>(corners));
    return counts;
}

void addCellArrays(const TissueModel& tissue, const VtkTissue& ofPoints, VtkContent& content) {
    std::vector<double> springConstants, viscosities, restLengths;
    for (const auto& [springConstant, viscosity] : springValues(tissue)) {
        springConstants.push_back(springConstant);
        viscosities.push_back(viscosity);
    }
    for (const Spring& spring : tissue.network->springs)
        restLengths.push_back(spring.restLength);
    const std::vector<double> none(ofPoints.viscosity.size(), 0);
    content.ofCells = {
        {"spring_constant", "N/m", 1, ofAllCells(content, springConstants, ofPoints.springConstant)},
        {"viscosity", "N·s/m", 1, ofAllCells(content, viscosities, ofPoints.viscosity)},
        {"rest_length", "m", 1, ofAllCells(content, restLengths, none)},
        {"corners", "", 1, cornerCounts(content)}};
}

/// Of a table that neither points nor cells have.
void addTable(ModelTable table, VtkContent& content) {
    for (TableColumn& column : table.columns) {
        VtkArray array{table.name + '_' + column.name, column.unit, partsOf(column), {}};
        std::visit([&](auto& values) { array.values = std::move(values); }, column.values);
        content.ofAll.push_back(std::move(array));
    }
}

void addTables(const Handover& handover, const VtkPoints& points, VtkVolumes volumes, VtkContent& content) {
    for (ModelTable& table : modelTables(handover)) {
        const bool isOfCells =
            table.name == "springs" || (table.name == "tetrahedra" && volumes == VtkVolumes::Yes);
        if (table.name == "nodes" || isOfCells) continue;
        if (table.name == "vertices")
            table.columns.push_back(
                {"point",
                 "",
                 {},
                 std::vector<std::int32_t>(points.ofVertices.begin(), points.ofVertices.end())});
        addTable(std::move(table), content);
    }
}

} // namespace

VtkContent vtkContentOf(const Handover& handover, VtkVolumes volumes, const Progress& progress) {
    const SpringNetwork& network = *handover.tissue.network;
    const VtkPoints points = pointsOf(*handover.project.mesh, network);
    VtkContent content;
    content.places = {"Points", "m", 3, coordinatesOf(points.places)};
    reportProgress(progress, 0.2);
    addCells(handover, points, volumes, content);
    reportProgress(progress, 0.4);
    const VtkTissue ofPoints{carriedBy(network, points, handover.tissue.springConstant),
                             carriedBy(network, points, handover.tissue.viscosity)};
    addPointArrays(handover.tissue, points, ofPoints, content);
    if (!handover.project.regions.empty()) addRegions(handover, points, content);
    reportProgress(progress, 0.6);
    addCellArrays(handover.tissue, ofPoints, content);
    reportProgress(progress, 0.8);
    addTables(handover, points, volumes, content);
    reportProgress(progress, 1);
    return content;
}

} // namespace esm
