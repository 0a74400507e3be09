#include "core/exchange/model_package.h"
#include "core/exchange/package/drawn_tissue.h"
#include "core/exchange/package/glb.h"
#include "core/exchange/package/package_checksums.h"
#include "core/exchange/package/package_layout.h"
#include "core/exchange/package/package_materials.h"
#include "core/exchange/package/page_vertices.h"
#include "core/exchange/package/tissue_writer.h"
#include "core/exchange/package/xmp_packet.h"
#include "core/exchange/picture_encoding.h"
#include "core/exchange/project/model_json.h"
#include "core/exchange/project/region_json.h"
#include "core/project/continuum.h"
#include "core/support/errors.h"
#include "core/texture/maps/ambient_occlusion.h"
#include "core/texture/maps/finish_pages.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

/// A handover with its texture and its picture.
struct Ingredients {
    const Project& project;
    const TissueModel& tissue;
    BakedPages pages;
    std::vector<Image> occlusion; ///< a page each; empty: not asked for
    Image preview;                ///< empty: none
    PictureEncoding pictures;     ///< of the pages' colours
    Provenance provenance;
};

constexpr const char* program = "Elastodynamic Shape Modeler " ESM_VERSION;

constexpr double pagesShare = 0.8; ///< of building, that the pictures of pages take

/// Accessors that the drawn mesh and the extension share.
struct Shared {
    std::size_t vertexPositions = 0, vertexNodes = 0, triangles = 0;
};

class PackageBuilder {
public:
    PackageBuilder(const Ingredients& from, const Progress& progress)
        : m_from(from), m_network(*from.tissue.network), m_mesh(*from.project.mesh), m_parts(progress),
          m_normals(vertexNormals(m_mesh.vertices, m_mesh.triangles)), m_arrays(m_glb),
          m_tissue(from.tissue, m_arrays) {}

    Glb build();
    const std::vector<std::string>& problems() const { return m_problems; }

private:
    Json surface();
    int version() const;
    Json extension();

    bool isBound() const { return m_network.binding && !m_mesh.vertices.empty(); }
    Json drawnPages(Json& drawn);
    Json drawnPage(std::size_t page, const std::vector<std::uint32_t>& triangles, const Progress& progress,
                   Json& drawn);
    Json drawnSurface(Json& drawn);
    Json drawnNetwork(Json& drawn);
    void addMaterial(const MaterialTextures& textures);
    MaterialTextures addTextures(std::size_t page, const std::optional<MaterialPage>& finish,
                                 const Progress& progress);
    std::size_t addImage(const std::string& name, const Image& image, const PictureEncoding& encoding,
                         double texelsPerMetre, const Progress& progress);
    std::size_t addTexture(const std::string& name, const Image& page, const PictureEncoding& encoding,
                           const Progress& progress);
    std::size_t addPreview();
    void addProvenance();
    void addAttributes(Json& primitives);

    const Ingredients& m_from;
    const SpringNetwork& m_network;
    const TriangleMesh& m_mesh;
    ProgressParts m_parts;
    const std::vector<Eigen::Vector3d> m_normals;
    Glb m_glb;
    GltfArrays m_arrays;
    Shared m_shared;
    std::vector<std::vector<std::uint32_t>> m_drawn; ///< vertices of the surface that each primitive draws
    TissueWriter m_tissue;
    std::vector<std::string> m_problems;
};

Json PackageBuilder::surface() {
    Json json{{"vertexCount", m_mesh.vertices.size()}, {"triangleCount", m_mesh.triangles.size()}};
    if (m_mesh.vertices.empty()) return json;
    m_shared.vertexPositions =
        m_mesh.vertices == m_network.restPositions
            ? m_tissue.nodePositions()
            : m_arrays.addFloats(m_tissue.coordinates(m_mesh.vertices, "coordinate of a vertex"),
                                 GltfType::Vec3, GltfTarget::Vertices);
    m_shared.vertexNodes = m_arrays.addIndices(m_network.vertexNodes);
    json["restPosition"] = m_shared.vertexPositions;
    json["vertexNodes"] = m_shared.vertexNodes;
    if (m_mesh.triangles.empty()) return json;
    m_shared.triangles = m_arrays.addIndices(cornersOf(m_mesh.triangles), GltfTarget::Indices);
    json["triangles"] = m_shared.triangles;
    return json;
}

int PackageBuilder::version() const {
    const VersionNeeds needs = needsOf(m_from.project.regions, m_from.project.base, isBound());
    if (needs.clinicalUnits) return package_layout::versionOfClinicalUnits;
    if (needs.bending) return package_layout::versionOfHinges;
    if (m_tissue.hasFillings()) return package_layout::versionOfFillings;
    if (m_network.lattice) return package_layout::versionOfFilled(m_network.lattice->filling.kind);
    if (m_from.pages.colours && isStretched(m_from.project.atlas->options.layout))
        return package_layout::versionOfStretchedLayouts;
    if (hasOwnValues(m_from.tissue)) return package_layout::versionOfOwnValues;
    if (isBound() && needsStarts(*m_network.binding)) return package_layout::versionOfWideBindings;
    return versionOf(needs);
}

Json PackageBuilder::extension() {
    const Project& project = m_from.project;
    RegionsJson regions = toJson(project.regions);
    Json json{{"version", version()},
              {"name", project.name},
              {"units", package_layout::units},
              {"damping", "isotropic"}};
    if (m_from.tissue.stiffening) json["stiffening"] = writtenFields(*m_from.tissue.stiffening);
    json["nodes"] = m_tissue.nodes();
    json["springs"] = m_tissue.springs();
    json["tethers"] = m_tissue.tethers();
    json["fixedNodes"] = m_tissue.fixedNodes();
    if (!m_from.tissue.hinges.empty()) json["hinges"] = m_tissue.hinges();
    json["surface"] = surface();
    if (m_tissue.hasFillings()) json["fillings"] = m_tissue.fillings();
    if (!project.scene.pressures.empty()) json["pressures"] = written(project.scene.pressures);
    if (isBound()) json["binding"] = m_tissue.binding();
    if (m_network.sheet) json["sheet"] = m_tissue.sheet();
    if (m_network.lattice) json["lattice"] = m_tissue.lattice();
    json["base"] = writtenFields(project.base);
    json["fuzzySystems"] = std::move(regions.systems);
    json["regions"] = std::move(regions.regions);
    if (project.stepping) json["stepping"] = toJson(*project.stepping);
    json["baseColour"] = project.texture.baseColour;
    json["provenance"] = writtenFields(m_from.provenance);
    if (m_from.pages.colours) json["texture"] = textureOf(*m_from.project.atlas);
    return json;
}

void PackageBuilder::addMaterial(const MaterialTextures& textures) {
    const TextureSettings& settings = m_from.project.texture;
    m_glb.json["materials"].push_back(materialOf(textures, settings.baseColour, settings.finish));
}

/// @param name under which other programs list it
std::size_t PackageBuilder::addImage(const std::string& name, const Image& image,
                                     const PictureEncoding& encoding, double texelsPerMetre,
                                     const Progress& progress) {
    Json& images = m_glb.json["images"];
    const Bytes file = encodePicture(image, encoding, texelsPerMetre, progress);
    images.push_back(
        {{"bufferView", m_arrays.addFile(file)}, {"mimeType", mediaTypeOf(encoding.format)}, {"name", name}});
    return images.size() - 1;
}

std::size_t PackageBuilder::addTexture(const std::string& name, const Image& page,
                                       const PictureEncoding& encoding, const Progress& progress) {
    const std::size_t image = addImage(name, page, encoding, m_from.project.atlas->texelsPerMetre, progress);
    m_glb.json["textures"].push_back({{"sampler", 0}, {"source", image}});
    return m_glb.json["textures"].size() - 1;
}

/// What is no colour stays exact: a JPEG would tilt normals and mix wetness with roughness.
MaterialTextures PackageBuilder::addTextures(std::size_t page, const std::optional<MaterialPage>& finish,
                                             const Progress& progress) {
    ProgressParts parts(progress);
    const std::string name = "page " + std::to_string(page + 1);
    MaterialTextures textures;
    textures.colour =
        addTexture(name, (*m_from.pages.colours)[page], m_from.pictures, parts.next(finish ? 0.4 : 0.8));
    if (!m_from.occlusion.empty())
        textures.occlusion = addTexture(name + " occlusion", m_from.occlusion[page], {}, parts.next(0.2));
    if (!finish) return textures;
    textures.wetnessAndRoughness =
        addTexture(name + " wetness and roughness", finish->wetnessAndRoughness, {}, parts.next(0.2));
    if (!finish->normals.empty())
        textures.normals = addTexture(name + " normals", finish->normals, {}, parts.rest());
    return textures;
}

std::size_t PackageBuilder::addPreview() {
    return addImage("preview", m_from.preview, {}, 0, {});
}

Json PackageBuilder::drawnPage(std::size_t page, const std::vector<std::uint32_t>& triangles,
                               const Progress& progress, Json& drawn) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    std::optional<MaterialPage> finish;
    if (m_from.pages.finish) finish = materialPage((*m_from.pages.finish)[page]);
    const bool isTilted = finish && !finish->normals.empty();
    const PageVertices vertices =
        pageVertices(m_from.project, m_normals, triangles, isTilted ? WithTangents::Yes : WithTangents::No);
    reportProgress(parts.next(0.1), 1);
    Json attributes;
    attributes["POSITION"] = m_arrays.addFloats(m_tissue.coordinates(vertices.positions, "coordinate"),
                                                GltfType::Vec3, GltfTarget::Vertices);
    reportProgress(parts.next(0.1), 1);
    attributes["NORMAL"] = m_arrays.addFloats(m_tissue.coordinates(vertices.normals, "normal"),
                                              GltfType::Vec3, GltfTarget::Vertices);
    reportProgress(parts.next(0.1), 1);
    attributes["TEXCOORD_0"] = m_arrays.addFloats(vertices.places, GltfType::Vec2, GltfTarget::Vertices);
    const std::size_t order = m_arrays.addIndices(vertices.corners, GltfTarget::Indices);
    const MaterialTextures textures = addTextures(page, finish, parts.next(0.6));
    if (isTilted)
        attributes["TANGENT"] = m_arrays.addFloats(vertices.tangents, GltfType::Vec4, GltfTarget::Vertices);
    reportProgress(parts.rest(), 0);
    addMaterial(textures);
    drawn.push_back({{"mesh", 0},
                     {"primitive", drawn.size()},
                     {"vertexNodes", m_arrays.addIndices(vertices.nodes)},
                     {"triangles", m_arrays.addIndices(triangles)}});
    if (isBound()) drawn.back()["vertices"] = m_arrays.addIndices(vertices.vertices);
    m_drawn.push_back(vertices.vertices);
    return {{"attributes", attributes}, {"indices", order}, {"material", m_glb.json["materials"].size() - 1}};
}

Json PackageBuilder::drawnPages(Json& drawn) {
    constexpr int linear = 9729, clampToEdge = 33071; // mip-maps would mix patches that are not neighbours
    m_glb.json["samplers"].push_back(
        {{"magFilter", linear}, {"minFilter", linear}, {"wrapS", clampToEdge}, {"wrapT", clampToEdge}});
    std::vector<std::vector<std::uint32_t>> pages(m_from.pages.colours->size());
    for (std::uint32_t triangle = 0; triangle < m_mesh.triangles.size(); ++triangle)
        pages[m_from.project.atlas->page[triangle]].push_back(triangle);
    Json primitives = Json::array();
    for (std::size_t page = 0; page < pages.size(); ++page) {
        const Progress progress = m_parts.next(pagesShare / static_cast<double>(pages.size()));
        if (!pages[page].empty()) primitives.push_back(drawnPage(page, pages[page], progress, drawn));
    }
    return primitives;
}

Json PackageBuilder::drawnSurface(Json& drawn) {
    addMaterial({});
    std::vector<std::uint32_t> triangles(m_mesh.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0U);
    const Json attributes{{"POSITION", m_shared.vertexPositions},
                          {"NORMAL", m_arrays.addFloats(m_tissue.coordinates(m_normals, "normal"),
                                                        GltfType::Vec3, GltfTarget::Vertices)}};
    drawn.push_back({{"mesh", 0},
                     {"primitive", 0},
                     {"vertexNodes", m_shared.vertexNodes},
                     {"triangles", m_arrays.addIndices(triangles)}});
    std::vector<std::uint32_t> vertices(m_mesh.vertices.size());
    std::iota(vertices.begin(), vertices.end(), 0U);
    if (isBound()) drawn.back()["vertices"] = m_arrays.addIndices(vertices);
    m_drawn.push_back(std::move(vertices));
    Json primitive{{"attributes", attributes}, {"indices", m_shared.triangles}, {"material", 0}};
    return Json::array({std::move(primitive)});
}

/// A model without surface shows its springs as lines, or its nodes as points.
Json PackageBuilder::drawnNetwork(Json& drawn) {
    constexpr int points = 0, lines = 1;
    std::vector<std::uint32_t> nodes(m_network.restPositions.size());
    std::iota(nodes.begin(), nodes.end(), 0U);
    drawn.push_back({{"mesh", 0}, {"primitive", 0}, {"vertexNodes", m_arrays.addIndices(nodes)}});
    m_drawn.push_back(std::move(nodes));
    Json primitive{{"attributes", {{"POSITION", m_tissue.nodePositions()}}},
                   {"mode", m_network.springs.empty() ? points : lines}};
    if (!m_network.springs.empty()) primitive["indices"] = m_tissue.springNodes();
    return Json::array({std::move(primitive)});
}

/// For programs that know XMP and not this package. What every package of the program would say needs none.
void PackageBuilder::addProvenance() {
    const Provenance& provenance = m_from.provenance;
    if (!provenance.source && provenance.authorship == Authorship()) return;
    m_glb.json["extensionsUsed"].push_back(xmpExtension);
    m_glb.json["asset"]["extensions"][xmpExtension] = {{"packet", 0}};
    m_glb.json["extensions"][xmpExtension]["packets"] = Json::array({xmpPacket(provenance)});
}

/// Behind all arrays of before, so that those stay where they were.
void PackageBuilder::addAttributes(Json& primitives) {
    const DrawnTissue tissue =
        drawnTissue(m_from.tissue, m_mesh.triangles.empty() ? 0 : m_mesh.vertices.size());
    for (std::size_t i = 0; i < m_drawn.size(); ++i)
        addTissueAttributes(tissue, m_drawn[i], m_arrays, primitives[i]["attributes"]);
}

Glb PackageBuilder::build() {
    Json& gltf = m_glb.json;
    gltf["asset"] = {{"version", "2.0"}, {"generator", m_from.provenance.program}};
    gltf["extensionsUsed"] = Json::array({package_layout::extension});
    if (m_from.pages.finish || (m_from.project.texture.finish && !m_mesh.triangles.empty()))
        gltf["extensionsUsed"].push_back(clearcoatExtension);
    addProvenance();
    Json springMass = extension(), drawn = Json::array();
    reportProgress(m_parts.next(1 - pagesShare), 1);
    Json primitives = m_mesh.triangles.empty() ? drawnNetwork(drawn)
                      : m_from.pages.colours   ? drawnPages(drawn)
                                               : drawnSurface(drawn);
    springMass["drawn"] = std::move(drawn);
    if (!m_from.preview.empty()) springMass["preview"] = addPreview();
    addAttributes(primitives);
    if (m_network.lattice) springMass["springs"]["kind"] = m_tissue.springKinds();
    if (const auto material = continuumOf(m_from.project, m_from.tissue))
        springMass["material"] = m_tissue.material(*material);
    springMass["checksums"] = addChecksums(m_arrays);
    gltf["scene"] = 0;
    gltf["scenes"].push_back({{"nodes", Json::array({0})}});
    gltf["nodes"].push_back({{"mesh", 0}, {"name", m_from.project.name}});
    gltf["meshes"].push_back({{"primitives", std::move(primitives)}, {"name", m_from.project.name}});
    gltf["buffers"].push_back({{"byteLength", m_glb.binary.size()}});
    gltf["extensions"][package_layout::extension] = std::move(springMass);
    for (const std::string& place : nonFiniteNumbers(gltf))
        m_problems.push_back(place + " is not a finite number");
    m_problems.insert(m_problems.end(), m_tissue.problems().begin(), m_tissue.problems().end());
    return std::move(m_glb);
}

} // namespace

void writePackage(const Handover& handover, const std::filesystem::path& file, const HandoverMeans& means) {
    const auto& [project, tissue] = handover;
    ProgressParts parts(means.progress);
    if (auto problems = validate(means.authorship); !problems.empty()) throw InvalidModel(problems);
    const double reach = project.texture.occlusionReach;
    const bool isShaded = project.atlas && reach > 0;
    BakedPages pages = bakedPages(project, parts.next(!project.atlas ? 0 : isShaded ? 0.3 : 0.6));
    const Provenance provenance{program, project.source, means.authorship};
    Ingredients ingredients{project, tissue, std::move(pages), {}, {}, means.pictures, provenance};
    if (isShaded)
        ingredients.occlusion = occlusionPages(*project.mesh, *project.atlas, reach, parts.next(0.3));
    if (means.drawPreview) ingredients.preview = means.drawPreview(project, ingredients.pages);
    reportProgress(parts.next(0.05), 1);
    PackageBuilder builder(ingredients, parts.next(0.3));
    Glb glb = builder.build();
    if (!builder.problems().empty()) throw InvalidModel(builder.problems());
    fillChecksums(glb);
    reportProgress(parts.next(0.01), 1);
    const Bytes content = writeGlb(glb);
    writeFileAtomically(file, content, parts.rest());
}

} // namespace esm
