#include "core/exchange/model_package.h"
#include "core/exchange/package/glb.h"
#include "core/exchange/package/package_container.h"
#include "core/exchange/package/package_drawn.h"
#include "core/exchange/package/package_layout.h"
#include "core/exchange/project/model_json.h"
#include "core/exchange/project/region_json.h"
#include "core/project/project_warnings.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

class PackageReader {
public:
    PackageReader(const Glb& glb, std::vector<std::string>& problems)
        : m_json(glb.json, "", problems), m_arrays(glb, problems), m_largest(glb.binary.size()),
          m_problems(problems) {}

    ModelPackage read();

private:
    std::vector<double> scalars(const JsonReader& group, const char* key, std::size_t count) const {
        const std::vector<float> values = m_arrays.floats(group.member(key), GltfType::Scalar, count);
        return {values.begin(), values.end()};
    }
    std::size_t countOf(const JsonReader& group, const char* key = "count") const {
        return static_cast<std::size_t>(group.member(key).integer(0, m_largest));
    }

    void requireExtension() const;
    void checkVersion(const JsonReader& extension, const ModelPackage& package) const;
    void checkStiffening(const JsonReader& extension, const ModelPackage& package) const;
    void readNodes(const JsonReader& group, SpringNetwork& network, TissueModel& tissue) const;
    void readSprings(const JsonReader& group, SpringNetwork& network, const TissueModel& tissue) const;
    void readTethers(const JsonReader& group, TissueModel& tissue) const;
    void readSurface(const JsonReader& group, SpringNetwork& network, TriangleMesh& mesh) const;
    void readBinding(const JsonReader& group, SpringNetwork& network, std::size_t vertices) const;
    void checkMean(const JsonReader& spring, const char* key, const SpringNetwork& network,
                   const std::vector<double>& ofNodes) const;

    JsonReader m_json;
    GltfArrayReader m_arrays;
    std::size_t m_largest;
    std::vector<std::string>& m_problems;
};

void PackageReader::requireExtension() const {
    const std::string name = package_layout::extension;
    if (!m_json.has("extensions") || !m_json.member("extensions").has(name.c_str()))
        throw InvalidModel("is a glTF file, but no model package: it has no " + name);
    refuseNewerVersion(m_json.member("extensions").member(name.c_str()), modelPackageVersion);
    const auto names = [&](const char* list) {
        if (!m_json.has(list)) return false;
        const std::vector<std::string> all = m_json.member(list).texts();
        return std::find(all.begin(), all.end(), name) != all.end();
    };
    if (m_json.member("asset").member("version").text() != "2.0")
        m_problems.push_back("asset/version should be 2.0");
    if (!names("extensionsUsed")) m_problems.push_back("extensionsUsed should name " + name);
    if (names("extensionsRequired")) m_problems.push_back("extensionsRequired should not name " + name);
}

/// A reader of the version that the file says it is would take stiffer springs for linear, or infer
/// otherwise.
void PackageReader::checkVersion(const JsonReader& extension, const ModelPackage& package) const {
    const auto needed = static_cast<std::uint64_t>(
        versionOf(needsOf(package.regions, extension.has("binding"), package.tissue.stiffening.has_value())));
    if (extension.member("version").integer(1, modelPackageVersion) < needed)
        extension.member("version").addProblem("should be " + std::to_string(needed) + " for what it holds");
}

void PackageReader::checkStiffening(const JsonReader& extension, const ModelPackage& package) const {
    if (!(package.tissue.stiffening == package.base.stiffening))
        extension.member("base").addProblem("should have the same stiffening as the package");
}

void PackageReader::readNodes(const JsonReader& group, SpringNetwork& network, TissueModel& tissue) const {
    const std::size_t count = countOf(group);
    network.restPositions = pointsOf(m_arrays.floats(group.member("restPosition"), GltfType::Vec3, count));
    tissue.mass = scalars(group, "mass", count);
    tissue.springConstant = scalars(group, "springConstant", count);
    tissue.viscosity = scalars(group, "viscosity", count);
}

/// A package that says one thing per spring and another per node would run differently in different
/// simulators.
void PackageReader::checkMean(const JsonReader& springs, const char* key, const SpringNetwork& network,
                              const std::vector<double>& ofNodes) const {
    const std::vector<double> values = scalars(springs, key, network.springs.size());
    if (!m_problems.empty()) return;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double first = ofNodes[network.springs[i].first], second = ofNodes[network.springs[i].second];
        const double allowed = package_layout::meanTolerance * std::max(std::abs(first), std::abs(second));
        if (std::abs(values[i] - (first + second) / 2) <=
            allowed + static_cast<double>(std::numeric_limits<float>::min()))
            continue;
        springs.member(key).addProblem("holds " + std::to_string(values[i]) + " for spring " +
                                       std::to_string(i) + ", but its ends' mean is " +
                                       std::to_string((first + second) / 2));
        return;
    }
}

void PackageReader::readSprings(const JsonReader& group, SpringNetwork& network,
                                const TissueModel& tissue) const {
    const std::size_t count = countOf(group);
    if (count == 0) return;
    const std::vector<std::uint32_t> ends =
        m_arrays.indices(group.member("nodes"), 2 * count, network.restPositions.size());
    const std::vector<double> restLengths = scalars(group, "restLength", count);
    if (ends.size() != 2 * count || restLengths.size() != count) return;
    for (std::size_t i = 0; i < count; ++i)
        network.springs.push_back({ends[2 * i], ends[2 * i + 1], restLengths[i]});
    checkMean(group, "springConstant", network, tissue.springConstant);
    checkMean(group, "viscosity", network, tissue.viscosity);
}

void PackageReader::readTethers(const JsonReader& group, TissueModel& tissue) const {
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

void PackageReader::readSurface(const JsonReader& group, SpringNetwork& network, TriangleMesh& mesh) const {
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

void PackageReader::readBinding(const JsonReader& group, SpringNetwork& network, std::size_t vertices) const {
    const std::size_t nodes = network.restPositions.size();
    const std::size_t triangles = countOf(group, "triangleCount"), lines = countOf(group, "lineCount");
    BindingNumbers numbers;
    numbers.nodes = m_arrays.indices(group.member("nodes"), 3 * vertices, nodes);
    const std::vector<float> shares = m_arrays.floats(group.member("shares"), GltfType::Vec3, vertices);
    numbers.shares.assign(shares.begin(), shares.end());
    if (lines > 0) numbers.lines = m_arrays.indices(group.member("lines"), 2 * lines, nodes);
    std::vector<std::uint32_t> corners;
    if (triangles > 0) corners = m_arrays.indices(group.member("triangles"), 3 * triangles, nodes);
    network.binding = bindingOf(numbers, trianglesOf(corners));
}

ModelPackage PackageReader::read() {
    requireExtension();
    const JsonReader extension = m_json.member("extensions").member(package_layout::extension);
    ModelPackage package;
    auto network = std::make_shared<SpringNetwork>();
    package.tissue.network = network;
    package.name = extension.member("name").text();
    if (extension.member("damping").text() != "isotropic")
        extension.member("damping").addProblem("should be isotropic");
    if (extension.has("stiffening"))
        package.tissue.stiffening = stiffeningFromJson(extension.member("stiffening"));
    readNodes(extension.member("nodes"), *network, package.tissue);
    readSprings(extension.member("springs"), *network, package.tissue);
    readTethers(extension.member("tethers"), package.tissue);
    const JsonReader fixed = extension.member("fixedNodes");
    if (const std::size_t count = countOf(fixed); count > 0)
        package.tissue.fixedNodes =
            m_arrays.indices(fixed.member("nodes"), count, network->restPositions.size());
    readSurface(extension.member("surface"), *network, package.mesh);
    if (extension.has("binding"))
        readBinding(extension.member("binding"), *network, package.mesh.vertices.size());
    package.base = baseTissueFromJson(extension.member("base"));
    checkStiffening(extension, package);
    package.regions = regionsFromJson(extension.member("fuzzySystems"), extension.member("regions"));
    checkVersion(extension, package);
    if (extension.has("stepping")) package.stepping = steppingFromJson(extension.member("stepping"));
    package.baseColour = colourFromJson(extension.member("baseColour"));
    if (m_problems.empty()) readDrawn(extension, m_arrays, m_problems, package);
    return package;
}

/// The parts that a project has too.
Project projectOf(const ModelPackage& package) {
    Project project;
    project.name = package.name;
    project.mesh = std::make_shared<TriangleMesh>(package.mesh);
    project.importReport = std::make_shared<RepairReport>();
    project.network = package.tissue.network;
    project.base = package.base;
    project.regions = package.regions;
    project.stepping = package.stepping;
    project.atlas = package.atlas;
    return project;
}

/// Problems of the parts that a project has too, and of the tissue.
std::vector<std::string> problemsOf(const ModelPackage& package, const Project& project) {
    std::vector<std::string> problems = validate(project);
    for (std::string& problem : validate(package.tissue))
        if (std::find(problems.begin(), problems.end(), problem) == problems.end())
            problems.push_back(std::move(problem));
    return problems;
}

struct ReadPackage {
    ModelPackage package; ///< of use only without problems
    std::vector<std::string> problems, warnings;
};

ReadPackage readPackage(const std::filesystem::path& file) {
    const Bytes content = readFile(file);
    std::vector<std::string> problems;
    try {
        const Glb glb = parseGlb(content);
        ModelPackage package = PackageReader(glb, problems).read();
        const Project project = projectOf(package);
        if (problems.empty()) problems = problemsOf(package, project);
        std::vector<std::string> warnings = containerWarnings(glb);
        if (!problems.empty()) return {{}, problems, warnings};
        const Json& extension = glb.json["extensions"][package_layout::extension];
        for (std::string& warning : steppingWarnings(extension))
            warnings.push_back(std::move(warning));
        for (std::string& warning : projectWarnings(project))
            warnings.push_back(std::move(warning));
        return {std::move(package), {}, std::move(warnings)};
    } catch (const InvalidModel& error) {
        return {{}, error.problems(), {}};
    }
}

} // namespace

bool isModelPackage(const std::filesystem::path& file) {
    std::error_code error;
    std::string start(4, '\0');
    if (std::filesystem::is_regular_file(file, error))
        std::ifstream(file, std::ios::binary).read(start.data(), 4);
    if (start == "glTF") return true;
    return start != std::string("PK\3\4", 4) && file.extension() == ".glb";
}

OpenedPackage openPackage(const std::filesystem::path& file) {
    ReadPackage read = readPackage(file);
    if (!read.problems.empty()) throw FileError(file, InvalidModel(read.problems).what());
    return {std::move(read.package), std::move(read.warnings)};
}

ModelPackage loadPackage(const std::filesystem::path& file) {
    return openPackage(file).package;
}

std::vector<std::string> validatePackage(const std::filesystem::path& file) {
    ReadPackage read = readPackage(file);
    read.problems.insert(read.problems.end(), read.warnings.begin(), read.warnings.end());
    return read.problems;
}

} // namespace esm
