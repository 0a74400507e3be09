#include "core/exchange/package/tissue_reader.h"

#include "core/exchange/package/package_layout.h"
#include "core/exchange/tissue_json.h"
#include "core/model/scene_cavities.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

/// Whatever their order and whichever corner they begin with.
bool isSameSurface(std::vector<Triangle> one, std::vector<Triangle> other) {
    for (std::vector<Triangle>* triangles : {&one, &other}) {
        for (Triangle& triangle : *triangles)
            std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        std::sort(triangles->begin(), triangles->end());
    }
    return one == other;
}

class TissueReader {
public:
    TissueReader(const GltfArrayReader& arrays, int version) : m_arrays(arrays), m_version(version) {}

    PackagedTissue read(const JsonReader& extension) const;

private:
    std::vector<double> scalars(const JsonReader& group, const char* key, std::size_t count) const {
        const std::vector<float> values = m_arrays.floats(group.member(key), GltfType::Scalar, count);
        return {values.begin(), values.end()};
    }
    std::size_t countOf(const JsonReader& group, const char* key = "count") const {
        return static_cast<std::size_t>(group.member(key).integer(0, m_arrays.bytes()));
    }

    void readNodes(const JsonReader& group, SpringNetwork& network, TissueModel& tissue) const;
    void readSprings(const JsonReader& group, SpringNetwork& network, TissueModel& tissue) const;
    void readOwnValues(const JsonReader& springs, TissueModel& tissue) const;
    void readTethers(const JsonReader& group, TissueModel& tissue) const;
    void readHinges(const JsonReader& group, TissueModel& tissue) const;
    void readSurface(const JsonReader& group, SpringNetwork& network, TriangleMesh& mesh) const;
    BindingNumbers readRows(const JsonReader& group, std::size_t nodes, std::size_t vertices) const;
    void readBinding(const JsonReader& group, SpringNetwork& network, std::size_t vertices) const;
    void readSheet(const JsonReader& group, SpringNetwork& network) const;
    void readLattice(const JsonReader& group, SpringNetwork& network) const;
    void readFluids(const JsonReader& extension, PackagedTissue& package) const;
    EquivalentMaterial readMaterial(const JsonReader& group, std::size_t nodes) const;
    void checkMean(const JsonReader& springs, const char* key, const SpringNetwork& network,
                   const std::vector<double>& ofNodes) const;

    const GltfArrayReader& m_arrays;
    int m_version;
};

void TissueReader::readNodes(const JsonReader& group, SpringNetwork& network, TissueModel& tissue) const {
    const std::size_t count = countOf(group);
    network.restPositions = pointsOf(m_arrays.floats(group.member("restPosition"), GltfType::Vec3, count));
    tissue.mass = scalars(group, "mass", count);
    tissue.springConstant = scalars(group, "springConstant", count);
    tissue.viscosity = scalars(group, "viscosity", count);
}

/// Before springs could have values of their own, a package that said one thing per spring and another per
/// node would have run differently in different simulators.
void TissueReader::checkMean(const JsonReader& springs, const char* key, const SpringNetwork& network,
                             const std::vector<double>& ofNodes) const {
    const std::vector<double> values = scalars(springs, key, network.springs.size());
    if (m_arrays.foundProblems()) return;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double first = ofNodes[network.springs[i].first], second = ofNodes[network.springs[i].second];
        if (isMean(values[i], first, second)) continue;
        springs.member(key).addProblem("holds " + std::to_string(values[i]) + " for spring " +
                                       std::to_string(i) + ", but its ends' mean is " +
                                       std::to_string((first + second) / 2));
        return;
    }
}

/// None where all are the mean: rounding to 32 bits gives no spring a value of its own.
void TissueReader::readOwnValues(const JsonReader& springs, TissueModel& tissue) const {
    const std::size_t count = tissue.network->springs.size();
    const std::vector<double> springConstants = scalars(springs, "springConstant", count);
    const std::vector<double> viscosities = scalars(springs, "viscosity", count);
    if (m_arrays.foundProblems()) return;
    for (std::size_t i = 0; i < count; ++i)
        tissue.ownValues.push_back({springConstants[i], viscosities[i]});
    if (!hasOwnValues(tissue)) tissue.ownValues.clear();
}

void TissueReader::readSprings(const JsonReader& group, SpringNetwork& network, TissueModel& tissue) const {
    const std::size_t count = countOf(group);
    if (count == 0) return;
    const std::vector<std::uint32_t> ends =
        m_arrays.indices(group.member("nodes"), 2 * count, network.restPositions.size());
    const std::vector<double> restLengths = scalars(group, "restLength", count);
    if (ends.size() != 2 * count || restLengths.size() != count) return;
    for (std::size_t i = 0; i < count; ++i)
        network.springs.push_back({ends[2 * i], ends[2 * i + 1], restLengths[i]});
    if (m_version >= package_layout::versionOfOwnValues) {
        readOwnValues(group, tissue);
    } else {
        checkMean(group, "springConstant", network, tissue.springConstant);
        checkMean(group, "viscosity", network, tissue.viscosity);
    }
}

void TissueReader::readTethers(const JsonReader& group, TissueModel& tissue) const {
    const std::size_t count = countOf(group);
    if (count == 0) return;
    const std::vector<std::uint32_t> nodes =
        m_arrays.indices(group.member("nodes"), count, tissue.mass.size());
    const std::vector<double> springConstants = scalars(group, "springConstant", count);
    const std::vector<double> viscosities = scalars(group, "viscosity", count);
    if (nodes.size() != count || springConstants.size() != count || viscosities.size() != count) return;
    for (std::size_t i = 0; i < count; ++i)
        tissue.tethers.push_back({nodes[i], springConstants[i], viscosities[i]});
}

void TissueReader::readHinges(const JsonReader& group, TissueModel& tissue) const {
    const std::size_t count = countOf(group);
    const std::vector<std::uint32_t> nodes =
        m_arrays.indices(group.member("nodes"), 4 * count, tissue.mass.size());
    const std::vector<double> stiffnesses = scalars(group, "stiffness", count);
    const std::vector<double> viscosities = scalars(group, "viscosity", count);
    if (nodes.size() != 4 * count || stiffnesses.size() != count || viscosities.size() != count) return;
    for (std::size_t i = 0; i < count; ++i)
        tissue.hinges.push_back({{nodes[4 * i], nodes[4 * i + 1], nodes[4 * i + 2], nodes[4 * i + 3]},
                                 stiffnesses[i],
                                 viscosities[i]});
}

void TissueReader::readSurface(const JsonReader& group, SpringNetwork& network, TriangleMesh& mesh) const {
    const std::size_t vertices = countOf(group, "vertexCount"), triangles = countOf(group, "triangleCount");
    if (vertices > 0) {
        mesh.vertices = pointsOf(m_arrays.floats(group.member("restPosition"), GltfType::Vec3, vertices));
        network.vertexNodes =
            m_arrays.indices(group.member("vertexNodes"), vertices, network.restPositions.size());
    }
    if (triangles == 0) return;
    mesh.triangles =
        trianglesOf(m_arrays.indices(group.member("triangles"), 3 * triangles, mesh.vertices.size()));
}

/// Starts of any kind: whether they are some is for validate() to say.
BindingNumbers TissueReader::readRows(const JsonReader& group, std::size_t nodes,
                                      std::size_t vertices) const {
    BindingNumbers numbers;
    std::size_t all = 3 * vertices;
    if (group.has("starts")) {
        constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
        numbers.starts = m_arrays.indices(group.member("starts"), vertices + 1, any);
        all = m_arrays.count(group.member("nodes"));
    }
    numbers.nodes = m_arrays.indices(group.member("nodes"), all, nodes);
    const std::vector<float> shares = numbers.starts
                                          ? m_arrays.floats(group.member("shares"), GltfType::Scalar, all)
                                          : m_arrays.floats(group.member("shares"), GltfType::Vec3, vertices);
    numbers.shares.assign(shares.begin(), shares.end());
    return numbers;
}

void TissueReader::readBinding(const JsonReader& group, SpringNetwork& network, std::size_t vertices) const {
    const std::size_t nodes = network.restPositions.size();
    const std::size_t triangles = countOf(group, "triangleCount"), lines = countOf(group, "lineCount");
    BindingNumbers numbers = readRows(group, nodes, vertices);
    if (lines > 0) numbers.lines = m_arrays.indices(group.member("lines"), 2 * lines, nodes);
    std::vector<std::uint32_t> corners;
    if (triangles > 0) corners = m_arrays.indices(group.member("triangles"), 3 * triangles, nodes);
    network.binding = bindingOf(numbers, trianglesOf(corners));
}

void TissueReader::readSheet(const JsonReader& group, SpringNetwork& network) const {
    network.sheet = SheetShares{scalars(group, "springShares", network.springs.size()),
                                scalars(group, "nodeShares", network.restPositions.size())};
}

void TissueReader::readLattice(const JsonReader& group, SpringNetwork& network) const {
    const std::size_t nodes = network.restPositions.size();
    const auto tetrahedra =
        static_cast<std::size_t>(group.member("tetrahedronCount").integer(1, mostTetrahedra));
    const std::size_t triangles = countOf(group, "triangleCount");
    Lattice lattice{
        valueFrom<LatticeFilling>(group), {}, {}, scalars(group, "springShares", network.springs.size())};
    lattice.tetrahedra = tetrahedraOf(m_arrays.indices(group.member("tetrahedra"), 4 * tetrahedra, nodes));
    lattice.surface = trianglesOf(m_arrays.indices(group.member("triangles"), 3 * triangles, nodes));
    if (m_arrays.foundProblems()) return;
    if (!isSameSurface(lattice.surface, outerTriangles(lattice.tetrahedra)))
        group.member("triangles")
            .addProblem("should be the faces of tetrahedra that have a neighbour on one side alone");
    if (network.binding && !network.binding->surface.empty())
        group.addProblem("should stand beside a binding without triangles");
    network.lattice = std::move(lattice);
}

/// A fluid names its part as a scene does, and what it encloses is looked for anew: of a file nothing is
/// believed.
void TissueReader::readFluids(const JsonReader& extension, PackagedTissue& package) const {
    TissueModel& tissue = package.tissue;
    Scene scene;
    if (extension.has("fillings")) readValue(extension.member("fillings"), scene.fillings, PlainForms());
    if (extension.has("pressures")) readValue(extension.member("pressures"), scene.pressures, PlainForms());
    if (m_arrays.foundProblems()) return;
    std::vector<std::string> problems = validate(scene, tissue.mass.size());
    try {
        if (problems.empty())
            tissue.cavities =
                cavitiesOf(scene, *tissue.network, simulatedSurface(package.mesh, *tissue.network));
    } catch (const InvalidModel& unfit) {
        problems = unfit.problems();
    }
    for (const std::string& problem : problems)
        extension.addProblem("holds what cannot be: " + problem);
    package.pressures = std::move(scene.pressures);
}

EquivalentMaterial TissueReader::readMaterial(const JsonReader& group, std::size_t nodes) const {
    EquivalentMaterial material;
    material.poissonsRatio = group.member("poissonsRatio").number();
    if (group.has("thickness")) material.thickness = group.member("thickness").number();
    material.youngsModulus = scalars(group, "youngsModulus", nodes);
    material.density = scalars(group, "density", nodes);
    return material;
}

PackagedTissue TissueReader::read(const JsonReader& extension) const {
    PackagedTissue package;
    auto network = std::make_shared<SpringNetwork>();
    package.tissue.network = network;
    package.name = extension.member("name").text();
    if (extension.member("damping").text() != "isotropic")
        extension.member("damping").addProblem("should be isotropic");
    if (extension.has("stiffening"))
        package.tissue.stiffening = valueFrom<SpringStiffening>(extension.member("stiffening"));
    readNodes(extension.member("nodes"), *network, package.tissue);
    readSprings(extension.member("springs"), *network, package.tissue);
    readTethers(extension.member("tethers"), package.tissue);
    if (extension.has("hinges")) readHinges(extension.member("hinges"), package.tissue);
    const JsonReader fixed = extension.member("fixedNodes");
    if (const std::size_t count = countOf(fixed); count > 0)
        package.tissue.fixedNodes =
            m_arrays.indices(fixed.member("nodes"), count, network->restPositions.size());
    const JsonReader surface = extension.member("surface");
    readSurface(surface, *network, package.mesh);
    if (extension.has("binding"))
        readBinding(extension.member("binding"), *network, countOf(surface, "vertexCount"));
    if (extension.has("sheet")) readSheet(extension.member("sheet"), *network);
    if (extension.has("lattice")) readLattice(extension.member("lattice"), *network);
    if (extension.has("fillings") || extension.has("pressures")) readFluids(extension, package);
    if (extension.has("material"))
        package.material = readMaterial(extension.member("material"), network->restPositions.size());
    if (extension.has("provenance"))
        package.provenance = valueFrom<Provenance>(extension.member("provenance"));
    if (extension.has("stepping")) package.stepping = steppingFromJson(extension.member("stepping"));
    return package;
}

} // namespace

JsonReader springMassOf(const JsonReader& gltf) {
    const std::string name = package_layout::extension;
    if (!gltf.has("extensions") || !gltf.member("extensions").has(name.c_str()))
        throw InvalidModel("is a glTF file, but no model package: it has no " + name);
    JsonReader extension = gltf.member("extensions").member(name.c_str());
    refuseNewerVersion(extension, modelPackageVersion);
    return extension;
}

void checkNamesOfExtension(const JsonReader& gltf) {
    const std::string name = package_layout::extension;
    const auto isUsed = [&] {
        const std::vector<std::string> all = gltf.member("extensionsUsed").texts();
        return std::find(all.begin(), all.end(), name) != all.end();
    };
    const JsonReader version = gltf.member("asset").member("version");
    if (version.text() != "2.0") version.addProblem("should be 2.0");
    if (!gltf.has("extensionsUsed") || !isUsed())
        gltf.addProblem("should name " + name + " in extensionsUsed");
}

PackagedTissue readTissue(const JsonReader& extension, const GltfArrayReader& arrays) {
    const auto version = static_cast<int>(extension.member("version").integer(1, modelPackageVersion));
    return TissueReader(arrays, version).read(extension);
}

} // namespace esm
