#include "core/exchange/project/network_reader.h"

#include "core/exchange/tissue_json.h"

#include <algorithm>

namespace esm {

namespace layout = project_layout;

namespace {

std::shared_ptr<const TriangleMesh> meshFrom(const JsonReader& arrays, ContentEntries& source) {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = pointsOf(source.numbers(arrays, layout::meshVertices, 3));
    mesh->triangles = trianglesOf(source.indices(arrays, layout::meshTriangles, 3, mesh->vertices.size()));
    if (arrays.has(layout::meshTextureCoordinates))
        mesh->textureCoordinates = flatTriangles(source.numbers(arrays, layout::meshTextureCoordinates, 6));
    return mesh;
}

Binding readBinding(const JsonReader& arrays, ContentEntries& source, std::size_t nodes) {
    const bool hasStarts = arrays.has(layout::bindingStarts);
    const std::size_t together = hasStarts ? 1 : 3;
    BindingNumbers numbers{{},
                           source.indices(arrays, layout::bindingNodes, together, nodes),
                           source.numbers(arrays, layout::bindingShares, together),
                           source.indices(arrays, layout::bindingLines, 2, nodes)};
    if (hasStarts) numbers.starts = source.array<std::uint32_t>(arrays, layout::bindingStarts, 1);
    if (numbers.nodes.size() != numbers.shares.size() && !source.foundProblems())
        arrays.addProblem("give " + std::to_string(numbers.nodes.size()) +
                          " nodes that carry vertices, but " + std::to_string(numbers.shares.size()) +
                          " shares");
    return bindingOf(numbers, trianglesOf(source.indices(arrays, layout::bindingSurface, 3, nodes)));
}

Lattice readLattice(const LatticeFilling& filling, const JsonReader& arrays, ContentEntries& source,
                    std::size_t nodes) {
    Lattice lattice{filling, {}, {}, source.numbers(arrays, layout::latticeSpringShares, 1)};
    arrays.member(layout::latticeTetrahedra).integer(0, 4 * mostTetrahedra);
    lattice.tetrahedra = tetrahedraOf(source.indices(arrays, layout::latticeTetrahedra, 4, nodes));
    // Of numbers that were refused none is looked up: they may be of any size.
    if (!source.foundProblems()) lattice.surface = outerTriangles(lattice.tetrahedra);
    return lattice;
}

std::shared_ptr<const SpringNetwork> networkFrom(const JsonReader& manifest, ContentEntries& source) {
    const JsonReader arrays = manifest.member("arrays");
    auto network = std::make_shared<SpringNetwork>();
    network->restPositions = pointsOf(source.numbers(arrays, layout::networkNodes, 3));
    const std::size_t nodes = network->restPositions.size();
    const std::vector<std::uint32_t> ends = source.indices(arrays, layout::networkSprings, 2, nodes);
    const std::vector<double> restLengths = source.numbers(arrays, layout::networkRestLengths, 1);
    if (ends.size() != 2 * restLengths.size() && !source.foundProblems())
        arrays.addProblem("give " + std::to_string(ends.size() / 2) + " springs, but " +
                          std::to_string(restLengths.size()) + " rest lengths");
    for (std::size_t i = 0; i < std::min(restLengths.size(), ends.size() / 2); ++i)
        network->springs.push_back({ends[2 * i], ends[2 * i + 1], restLengths[i]});
    network->vertexNodes = source.indices(arrays, layout::networkVertexNodes, 1, nodes);
    if (arrays.has(layout::bindingNodes)) network->binding = readBinding(arrays, source, nodes);
    if (arrays.has(layout::sheetSpringShares))
        network->sheet = SheetShares{source.numbers(arrays, layout::sheetSpringShares, 1),
                                     source.numbers(arrays, layout::sheetNodeShares, 1)};
    if (manifest.has("lattice"))
        network->lattice =
            readLattice(valueFrom<LatticeFilling>(manifest.member("lattice")), arrays, source, nodes);
    return network;
}

const std::vector<std::string> networkEntries{
    layout::networkNodes,       layout::networkSprings,      layout::networkRestLengths,
    layout::networkVertexNodes, layout::bindingStarts,       layout::bindingNodes,
    layout::bindingShares,      layout::bindingSurface,      layout::bindingLines,
    layout::latticeTetrahedra,  layout::latticeSpringShares, layout::sheetSpringShares,
    layout::sheetNodeShares};

} // namespace

std::shared_ptr<const TriangleMesh> readMesh(const JsonReader& arrays, ContentEntries& source) {
    return source.shared<TriangleMesh>(
        "mesh", {layout::meshVertices, layout::meshTriangles, layout::meshTextureCoordinates},
        [&] { return meshFrom(arrays, source); });
}

std::shared_ptr<const SpringNetwork> readNetwork(const JsonReader& manifest, ContentEntries& source) {
    const std::string kind =
        manifest.has("lattice") ? "lattice " + manifestText(manifest.member("lattice").json()) : "network";
    return source.shared<SpringNetwork>(kind, networkEntries, [&] { return networkFrom(manifest, source); });
}

} // namespace esm
