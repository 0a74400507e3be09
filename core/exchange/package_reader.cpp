#include "core/exchange/glb.h"
#include "core/exchange/model_json.h"
#include "core/exchange/model_package.h"
#include "core/exchange/package_layout.h"
#include "core/exchange/region_json.h"
#include "core/support/errors.h"
#include "core/texture/photo_format.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

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

    struct DrawnPart {
        JsonReader primitive;
        std::vector<std::uint32_t> triangles, indices, vertexNodes;
        std::vector<std::uint32_t> vertices; ///< of the surface; empty where the file names none
        std::vector<Eigen::Vector3d> positions;
        std::vector<float> places; ///< in the texture; two per vertex, empty without texture
    };
    void readDrawn(const JsonReader& extension, ModelPackage& package) const;
    JsonReader primitiveOf(const JsonReader& drawn) const;
    DrawnPart readPart(const JsonReader& drawn, const TriangleMesh& mesh, std::size_t nodes) const;
    void checkPart(const JsonReader& drawn, const DrawnPart& part, const ModelPackage& package) const;
    void placePart(const JsonReader& drawn, const DrawnPart& part, std::size_t page, Atlas& atlas) const;
    std::shared_ptr<Atlas> readAtlas(const JsonReader& texture, std::size_t pages,
                                     std::size_t triangles) const;
    JsonReader imageOf(const JsonReader& primitive) const;
    Image readPage(const JsonReader& image, int size) const;
    void readPages(const std::vector<JsonReader>& primitives, ModelPackage& package) const;

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
    const auto needed =
        static_cast<std::uint64_t>(versionOf({extension.has("binding"), package.tissue.stiffening.has_value(),
                                              haveExtendedInference(package.regions)}));
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
    if (values.size() != network.springs.size() || ofNodes.size() != network.restPositions.size()) return;
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

JsonReader PackageReader::imageOf(const JsonReader& primitive) const {
    const JsonReader material = m_arrays.element("materials", primitive.member("material"));
    const JsonReader colour = material.member("pbrMetallicRoughness").member("baseColorTexture");
    const JsonReader texture = m_arrays.element("textures", colour.member("index"));
    return m_arrays.element("images", texture.member("source"));
}

/// Decodes nothing that is not of the page's size.
Image PackageReader::readPage(const JsonReader& image, int size) const {
    const Bytes png = m_arrays.file(image.member("bufferView"));
    if (png.empty()) return {};
    const PhotoFormat format = inspectPhoto(png);
    const auto expected = static_cast<std::uint64_t>(size);
    if (format.problem.empty() && (format.width != expected || format.height != expected)) {
        image.addProblem("should be " + std::to_string(size) + " by " + std::to_string(size) + " pixels");
        return {};
    }
    try {
        return decodePhoto(image.place(), png)->image;
    } catch (const FileError& error) {
        m_problems.emplace_back(error.what());
        return {};
    }
}

/// Pages are decoded once all else is known to be sound: there are few of them and each is drawn.
void PackageReader::readPages(const std::vector<JsonReader>& primitives, ModelPackage& package) const {
    std::set<std::string> named;
    for (const JsonReader& primitive : primitives) {
        const JsonReader image = imageOf(primitive);
        if (!image.json().is_null() && !named.insert(image.place()).second)
            image.addProblem("is the picture of two pages");
        else
            package.textures.push_back(readPage(image, package.atlas->options.size));
    }
}

/// The primitive of the glTF file that an entry of `drawn` speaks of; null where there is none.
JsonReader PackageReader::primitiveOf(const JsonReader& drawn) const {
    const JsonReader mesh = m_arrays.element("meshes", drawn.member("mesh"));
    const std::vector<JsonReader> primitives = mesh.member("primitives").elements();
    if (primitives.empty()) return drawn.nothing();
    return primitives[drawn.member("primitive").integer(0, primitives.size() - 1)];
}

PackageReader::DrawnPart PackageReader::readPart(const JsonReader& drawn, const TriangleMesh& mesh,
                                                 std::size_t nodes) const {
    const JsonReader primitive = primitiveOf(drawn), attributes = primitive.member("attributes");
    const std::size_t vertices = m_arrays.count(attributes.member("POSITION"));
    const std::size_t triangles = m_arrays.count(drawn.member("triangles"));
    DrawnPart part{primitive, {}, {}, {}, {}, {}, {}};
    part.positions = pointsOf(m_arrays.floats(attributes.member("POSITION"), GltfType::Vec3, vertices));
    part.vertexNodes = m_arrays.indices(drawn.member("vertexNodes"), vertices, nodes);
    if (drawn.has("vertices"))
        part.vertices = m_arrays.indices(drawn.member("vertices"), vertices, mesh.vertices.size());
    part.triangles = m_arrays.indices(drawn.member("triangles"), triangles, mesh.triangles.size());
    part.indices = m_arrays.indices(primitive.member("indices"), 3 * triangles, vertices);
    if (attributes.has("TEXCOORD_0"))
        part.places = m_arrays.floats(attributes.member("TEXCOORD_0"), GltfType::Vec2, vertices);
    return part;
}

/// What is drawn must be the surface that is simulated.
void PackageReader::checkPart(const JsonReader& drawn, const DrawnPart& part,
                              const ModelPackage& package) const {
    const TriangleMesh& mesh = package.mesh;
    for (std::size_t i = 0; i < part.indices.size(); ++i) {
        const std::uint32_t vertex = mesh.triangles[part.triangles[i / 3]][i % 3], shown = part.indices[i];
        const std::string corner =
            "corner " + std::to_string(i % 3) + " of triangle " + std::to_string(part.triangles[i / 3]);
        if (part.positions[shown] != mesh.vertices[vertex])
            return drawn.addProblem("shows " + corner + " elsewhere than the surface has it");
        if (part.vertexNodes[shown] != package.tissue.network->vertexNodes[vertex])
            return drawn.addProblem("ties " + corner + " to another node than the surface does");
        if (!part.vertices.empty() && part.vertices[shown] != vertex)
            return drawn.addProblem("takes " + corner + " for another vertex than the surface does");
    }
}

void PackageReader::placePart(const JsonReader& drawn, const DrawnPart& part, std::size_t page,
                              Atlas& atlas) const {
    if (part.places.empty()) return drawn.addProblem("has no texture coordinates");
    if (std::any_of(part.places.begin(), part.places.end(),
                    [](float value) { return value < 0 || value > 1; }))
        return drawn.addProblem("has texture coordinates beyond 0 to 1");
    for (std::size_t i = 0; i < part.indices.size(); ++i) {
        const std::size_t vertex = part.indices[i];
        const Eigen::Vector2d place(part.places[2 * vertex], part.places[2 * vertex + 1]);
        atlas.corners[part.triangles[i / 3]][i % 3] = place * atlas.options.size;
        atlas.page[part.triangles[i / 3]] = static_cast<std::uint16_t>(page);
    }
}

std::shared_ptr<Atlas> PackageReader::readAtlas(const JsonReader& texture, std::size_t pages,
                                                std::size_t triangles) const {
    auto atlas = std::make_shared<Atlas>();
    atlas->options.size =
        static_cast<int>(texture.member("size").integer(1, texture_limits::largestPageSize));
    atlas->options.pages = static_cast<int>(pages);
    atlas->options.gap = static_cast<int>(texture.member("gap").integer(0, texture_limits::largestPageSize));
    for (const std::string& problem : validate(atlas->options))
        texture.addProblem("is not usable: " + problem);
    atlas->texelsPerMetre = texture.member("texelsPerMetre").number();
    atlas->utilisation = texture.member("utilisation").number();
    atlas->corners.resize(triangles);
    atlas->page.resize(triangles);
    return atlas;
}

void PackageReader::readDrawn(const JsonReader& extension, ModelPackage& package) const {
    const std::vector<JsonReader> drawn = extension.member("drawn").elements();
    const std::size_t triangles = package.mesh.triangles.size();
    if (triangles == 0) return;
    if (drawn.empty() || drawn.size() > texture_limits::mostPages)
        return extension.member("drawn").addProblem("should have 1 to " +
                                                    std::to_string(texture_limits::mostPages) + " parts");
    std::shared_ptr<Atlas> atlas;
    if (extension.has("texture")) atlas = readAtlas(extension.member("texture"), drawn.size(), triangles);
    std::vector<int> timesDrawn(triangles, 0);
    std::vector<JsonReader> primitives;
    for (std::size_t page = 0; page < drawn.size(); ++page) {
        const std::size_t known = m_problems.size();
        const DrawnPart part =
            readPart(drawn[page], package.mesh, package.tissue.network->restPositions.size());
        if (m_problems.size() != known) continue;
        for (const std::uint32_t triangle : part.triangles)
            ++timesDrawn[triangle];
        checkPart(drawn[page], part, package);
        if (!atlas) continue;
        placePart(drawn[page], part, page, *atlas);
        primitives.push_back(part.primitive);
    }
    if (std::any_of(timesDrawn.begin(), timesDrawn.end(), [](int times) { return times != 1; }))
        extension.member("drawn").addProblem("should show every triangle of the surface once");
    package.atlas = atlas;
    if (m_problems.empty()) readPages(primitives, package);
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
    if (m_problems.empty()) readDrawn(extension, package);
    return package;
}

/// Problems of the parts that a project has too, and of the tissue.
std::vector<std::string> problemsOf(const ModelPackage& package) {
    Project project;
    project.name = package.name;
    project.mesh = std::make_shared<TriangleMesh>(package.mesh);
    project.importReport = std::make_shared<RepairReport>();
    project.network = package.tissue.network;
    project.base = package.base;
    project.regions = package.regions;
    project.stepping = package.stepping;
    project.atlas = package.atlas;
    std::vector<std::string> problems = validate(project);
    for (std::string& problem : validate(package.tissue))
        if (std::find(problems.begin(), problems.end(), problem) == problems.end())
            problems.push_back(std::move(problem));
    return problems;
}

/// The package and every problem of its file. The package is of use only without problems.
std::pair<ModelPackage, std::vector<std::string>> readPackage(const std::filesystem::path& file) {
    const Bytes content = readFile(file);
    std::vector<std::string> problems;
    try {
        const Glb glb = parseGlb(content);
        ModelPackage package = PackageReader(glb, problems).read();
        if (problems.empty()) problems = problemsOf(package);
        return {std::move(package), std::move(problems)};
    } catch (const InvalidModel& error) {
        return {{}, error.problems()};
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

ModelPackage loadPackage(const std::filesystem::path& file) {
    auto [package, problems] = readPackage(file);
    if (!problems.empty()) throw FileError(file, InvalidModel(problems).what());
    return std::move(package);
}

std::vector<std::string> validatePackage(const std::filesystem::path& file) {
    return readPackage(file).second;
}

} // namespace esm
