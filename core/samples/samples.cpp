#include "core/samples/samples.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/geometry/adjacency.h"
#include "core/samples/organs.h"
#include "core/support/errors.h"
#include "core/support/joined.h"

#include <array>

namespace esm {

namespace {

struct Sample {
    const char* name;
    Project (*make)();
};

constexpr std::array samples{Sample{"tube", makeTube}, Sample{"uterus", makeUterus},
                             Sample{"ventricle", makeVentricle}, Sample{"liver", makeLiver}};

} // namespace

const std::vector<std::string>& sampleNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        list.reserve(samples.size());
        for (const Sample& sample : samples)
            list.emplace_back(sample.name);
        return list;
    }();
    return names;
}

namespace {

Project numbered(Project project) {
    numberParts(project);
    return project;
}

} // namespace

Project makeSample(const std::string& name) {
    for (const Sample& sample : samples)
        if (name == sample.name) return numbered(sample.make());
    throw InvalidModel("there is no sample \"" + name + "\"; there are " + joinedNames(samples));
}

RepairedMesh asImported(TriangleMesh mesh) {
    RepairedMesh surface;
    const EdgeCounts edges = countEdges(sidesByEdge(mesh.triangles));
    surface.report.components = connectedParts(mesh.triangles, mesh.vertices.size()).count;
    surface.report.boundaryEdges = surface.report.boundaryEdgesBefore = edges.boundary;
    surface.report.nonManifoldEdges = surface.report.nonManifoldEdgesBefore = edges.nonManifold;
    surface.report.inconsistentEdges = edges.inconsistent;
    surface.mesh = std::move(mesh);
    return surface;
}

Region fuzzyRegion(std::string name, const std::string& preset, NamedValues inputs) {
    Region region;
    region.name = std::move(name);
    region.system = std::make_shared<const FuzzySystem>(fuzzyPreset(preset));
    region.inputs = std::move(inputs);
    return region;
}

InstrumentMotion pokeOf(const TriangleMesh& mesh, const Poke& poke) {
    const std::optional<RayHit> hit = SurfaceQuery(mesh.vertices, mesh.triangles).firstHit(poke.ray);
    if (!hit) throw InvalidModel("the instrument's ray misses the sample's surface");
    const Eigen::Vector3d along = poke.ray.direction.normalized();
    const Eigen::Vector3d touching = poke.ray.origin + (hit->distance - poke.radius) * along;
    const Eigen::Vector3d away = touching - poke.depth * along, deepest = touching + poke.depth * along;
    const double end = 0.5 * poke.duration; // the tissue needs the rest to come back
    return {
        Sphere{poke.radius}, {{0, away}, {0.4 * end, deepest}, {0.7 * end, deepest}, {end, away}}, {}, {}};
}

} // namespace esm
