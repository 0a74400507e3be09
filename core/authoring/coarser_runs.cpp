#include "core/authoring/coarser_runs.h"

#include "core/dynamics/spring_system.h"
#include "core/model/tissue_digest.h"
#include "core/project/detail_change.h"
#include "core/support/errors.h"

#include <numeric>

namespace esm {

namespace {

constexpr std::size_t fewestWorthMeasuring = 50; ///< nodes; fewer keep no organ's shape

/// The vertex at which each node shows; noIndex where it shows at none. Places are compared to the last bit,
/// as a node that was taken from a vertex has them: another level of detail is compared by what is drawn,
/// since its nodes are others.
std::vector<std::uint32_t> vertexOfEveryNode(const Project& project) {
    const SpringNetwork& network = *project.network;
    std::vector<std::uint32_t> vertices(network.restPositions.size(), noIndex);
    for (std::uint32_t vertex = 0; vertex < network.vertexNodes.size(); ++vertex) {
        const std::uint32_t node = network.vertexNodes[vertex];
        if (project.mesh->vertices[vertex] == network.restPositions[node]) vertices[node] = vertex;
    }
    return vertices;
}

/// The vertices at which the recorded nodes show; nothing where one shows at none.
std::optional<std::vector<std::uint32_t>> recordedVertices(const Project& project, const Scene& scene) {
    const std::vector<std::uint32_t> vertexOf = vertexOfEveryNode(project);
    std::vector<std::uint32_t> nodes(vertexOf.size());
    std::iota(nodes.begin(), nodes.end(), 0U);
    if (scene.record.nodes) nodes = *scene.record.nodes;
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t node : nodes) {
        if (vertexOf[node] == noIndex) return std::nullopt;
        vertices.push_back(vertexOf[node]);
    }
    return vertices;
}

// Of the binding only the recorded vertices are taken along, since all of them would be carried in every
// frame.
CoarserRun runOf(const Project& fewer, const Detail& detail, const std::vector<std::uint32_t>& vertices) {
    CoarserRun run{
        detail, evaluateModel(fewer), touchedSurface(*fewer.mesh, *fewer.network), fewer.scene, {}};
    run.scene.record.nodes.reset();
    Vectors rest;
    Binding binding{fewer.network->binding->surface, fewer.network->binding->lines, {}};
    for (const std::uint32_t vertex : vertices) {
        rest.push_back(fewer.mesh->vertices[vertex]);
        binding.vertices.add(fewer.network->binding->vertices[vertex]);
    }
    run.recorded = [rest, binding, network = fewer.network](const Vectors& positions) {
        return carried(rest, binding, network->restPositions, positions);
    };
    return run;
}

/// Nothing where so few nodes leave no room for the organ's fluids.
std::optional<Project> coarser(const Project& full, const Detail& detail, const Progress& progress) {
    try {
        return withDetail(full, detail, progress);
    } catch (const InvalidModel&) {
        return std::nullopt;
    }
}

} // namespace

// Each level has a quarter of the nodes of the last, so that edges are about twice as long: levels nearer to
// each other would cost a measurement each and differ little in error.
std::vector<CoarserRun> coarserRuns(const Project& project, const Scene& scene, const Progress& progress) {
    const Detail::Kind kind = detailOf(*project.network).kind;
    // A hollow organ is another one than a filled.
    if (kind == Detail::Kind::Rigid || kind == Detail::Kind::Filled || !scene.splits.empty()) return {};
    const auto vertices = recordedVertices(project, scene);
    if (!vertices) return {};
    Project full = project;
    full.scene = scene;
    ProgressParts parts(progress);
    std::vector<CoarserRun> runs;
    std::size_t last = full.network->restPositions.size();
    for (std::size_t nodes = last / 4; nodes >= fewestWorthMeasuring; nodes /= 4) {
        const Detail detail{Detail::Kind::Nodes, nodes, {}, full.network->sheet.has_value()};
        const auto fewer = coarser(full, detail, parts.nextOfRest(0.75));
        // A surface of many parts may have no fewer.
        if (!fewer || fewer->network->restPositions.size() >= last) break;
        last = fewer->network->restPositions.size();
        runs.push_back(runOf(*fewer, detail, *vertices));
    }
    return runs;
}

// The digest is taken of the tissue on the run's own nodes, after the change: with that of the tissue before,
// what is recommended would be out of date at once.
Project withRun(const Project& project, const TradeoffRun& run, const Progress& progress) {
    ProgressParts parts(progress);
    Project changed = run.coarser ? withDetail(project, *run.coarser, parts.next(0.9)) : project;
    changed.stepping = MeasuredStepping{run.stepping, run.error, run.wallPerSimulatedSecond,
                                        tissueDigest(evaluateModel(changed))};
    reportProgress(parts.rest(), 1);
    return changed;
}

} // namespace esm
