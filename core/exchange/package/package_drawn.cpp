#include "core/exchange/package/package_drawn.h"

#include "core/exchange/package/package_layout.h"
#include "core/exchange/package/package_materials.h"
#include "core/exchange/project/model_json.h"
#include "core/support/errors.h"
#include "core/texture/maps/finish_pages.h"
#include "core/texture/photo/photo_format.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <set>

namespace esm {

namespace {

class DrawnReader {
public:
    DrawnReader(const GltfArrayReader& arrays, std::vector<std::string>& problems)
        : m_arrays(arrays), m_problems(problems) {}

    void read(const JsonReader& extension, ModelPackage& package) const;
    Image readPreview(const JsonReader& preview) const;

private:
    struct DrawnPart {
        JsonReader primitive;
        std::vector<std::uint32_t> triangles, indices, vertexNodes;
        std::vector<std::uint32_t> vertices; ///< of the surface; empty where the file names none
        std::vector<Eigen::Vector3d> positions;
        std::vector<float> places; ///< in the texture; two per vertex, empty without texture
    };
    JsonReader primitiveOf(const JsonReader& drawn) const;
    DrawnPart readPart(const JsonReader& drawn, const TriangleMesh& mesh, std::size_t nodes) const;
    void checkPart(const JsonReader& drawn, const DrawnPart& part, const ModelPackage& package) const;
    void placePart(const JsonReader& drawn, const DrawnPart& part, std::size_t page, Atlas& atlas) const;
    std::shared_ptr<Atlas> readAtlas(const JsonReader& texture, std::size_t pages,
                                     std::size_t triangles) const;
    JsonReader materialOf(const JsonReader& primitive) const;
    JsonReader imageOf(const JsonReader& texture) const;
    template<class SizeProblem> Image readImage(const JsonReader& image, SizeProblem&& sizeProblem) const;
    Image readPage(const JsonReader& image, int size) const;
    void readPages(const std::vector<JsonReader>& primitives, ModelPackage& package) const;
    std::optional<TiledImage> readFinishPage(const JsonReader& material, const ModelPackage& package,
                                             std::set<std::string>& named) const;
    void readFinish(const std::vector<JsonReader>& primitives, ModelPackage& package) const;

    const GltfArrayReader& m_arrays;
    std::vector<std::string>& m_problems;
};

JsonReader DrawnReader::materialOf(const JsonReader& primitive) const {
    return m_arrays.element("materials", primitive.member("material"));
}

/// @param texture as a material names it
JsonReader DrawnReader::imageOf(const JsonReader& texture) const {
    const JsonReader named = m_arrays.element("textures", texture.member("index"));
    return m_arrays.element("images", named.member("source"));
}

/// Decodes nothing but what has the size. @param sizeProblem of width and height, pixels; empty when all is
/// well
template<class SizeProblem>
Image DrawnReader::readImage(const JsonReader& image, SizeProblem&& sizeProblem) const {
    const Bytes file = m_arrays.file(image.member("bufferView"));
    if (file.empty()) return {};
    const PhotoFormat format = inspectPhoto(file);
    const std::string problem = format.problem.empty() ? sizeProblem(format.width, format.height) : "";
    if (!problem.empty()) {
        image.addProblem(problem);
        return {};
    }
    try {
        return decodePhoto(image.place(), file)->image;
    } catch (const FileError& error) {
        m_problems.emplace_back(error.what());
        return {};
    }
}

Image DrawnReader::readPage(const JsonReader& image, int size) const {
    const auto expected = static_cast<std::uint64_t>(size);
    return readImage(image, [&](std::uint64_t width, std::uint64_t height) {
        if (width == expected && height == expected) return std::string();
        return "should be " + std::to_string(size) + " by " + std::to_string(size) + " pixels";
    });
}

Image DrawnReader::readPreview(const JsonReader& preview) const {
    return readImage(m_arrays.element("images", preview), [](std::uint64_t width, std::uint64_t height) {
        if (std::max(width, height) <= package_layout::largestPreview) return std::string();
        return "should be at most " + std::to_string(package_layout::largestPreview) +
               " pixels wide and high";
    });
}

/// Pages are decoded once all else is known to be sound: there are few of them and each is drawn.
void DrawnReader::readPages(const std::vector<JsonReader>& primitives, ModelPackage& package) const {
    std::set<std::string> named;
    for (const JsonReader& primitive : primitives) {
        const JsonReader surface = materialOf(primitive).member("pbrMetallicRoughness");
        const JsonReader image = imageOf(surface.member("baseColorTexture"));
        if (!image.json().is_null() && !named.insert(image.place()).second)
            image.addProblem("is the picture of two pages");
        else
            package.textures.push_back(readPage(image, package.atlas->options.size));
    }
}

/// What else materials may hold of other programs is theirs: a finish is read where the film's extension
/// stands, which our packages have wherever they have one. @param named pictures of the finish so far
std::optional<TiledImage> DrawnReader::readFinishPage(const JsonReader& material, const ModelPackage& package,
                                                      std::set<std::string>& named) const {
    const JsonReader surface = material.member("pbrMetallicRoughness");
    const auto pageOf = [&](const JsonReader& texture) -> Image {
        const JsonReader image = imageOf(texture);
        if (image.json().is_null() || named.insert(image.place()).second)
            return readPage(image, package.atlas->options.size);
        image.addProblem("is the picture of two pages");
        return {};
    };
    MaterialPage page{pageOf(surface.member("metallicRoughnessTexture")), {}};
    if (material.has("normalTexture")) page.normals = pageOf(material.member("normalTexture"));
    if (!m_problems.empty()) return std::nullopt;
    return finishPage(page);
}

void DrawnReader::readFinish(const std::vector<JsonReader>& primitives, ModelPackage& package) const {
    TiledPages pages;
    std::set<std::string> named;
    for (const JsonReader& primitive : primitives) {
        const JsonReader material = materialOf(primitive);
        if (!material.has("extensions") || !material.member("extensions").has(clearcoatExtension)) continue;
        const JsonReader surface = material.member("pbrMetallicRoughness");
        const JsonReader film = material.member("extensions").member(clearcoatExtension);
        if (surface.has("metallicRoughnessTexture")) {
            if (!package.atlas) return material.addProblem("has a picture of the finish without a texture");
            auto page = readFinishPage(material, package, named);
            if (!page) return;
            pages.push_back(std::move(*page));
            continue;
        }
        const SurfaceFinish finish{surface.member("roughnessFactor").number(),
                                   film.member("clearcoatFactor").number()};
        for (const std::string& problem : fieldProblems(finish))
            material.addProblem(problem);
        if (package.finish && !(*package.finish == finish))
            material.addProblem("shines otherwise than the page before");
        package.finish = finish;
    }
    if (pages.empty() || !m_problems.empty()) return;
    if (pages.size() != primitives.size() || package.finish)
        return primitives.front().addProblem("should have a picture of the finish, as every page or none");
    package.finishPages = std::make_shared<const TiledPages>(std::move(pages));
}

/// The primitive of the glTF file that an entry of `drawn` speaks of; null where there is none.
JsonReader DrawnReader::primitiveOf(const JsonReader& drawn) const {
    const JsonReader mesh = m_arrays.element("meshes", drawn.member("mesh"));
    const std::vector<JsonReader> primitives = mesh.member("primitives").elements();
    if (primitives.empty()) return drawn.nothing();
    return primitives[drawn.member("primitive").integer(0, primitives.size() - 1)];
}

DrawnReader::DrawnPart DrawnReader::readPart(const JsonReader& drawn, const TriangleMesh& mesh,
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
void DrawnReader::checkPart(const JsonReader& drawn, const DrawnPart& part,
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

void DrawnReader::placePart(const JsonReader& drawn, const DrawnPart& part, std::size_t page,
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

std::shared_ptr<Atlas> DrawnReader::readAtlas(const JsonReader& texture, std::size_t pages,
                                              std::size_t triangles) const {
    auto atlas = std::make_shared<Atlas>();
    atlas->options.size =
        static_cast<int>(texture.member("size").integer(1, texture_limits::largestPageSize));
    atlas->options.pages = static_cast<int>(pages);
    atlas->options.gap = static_cast<int>(texture.member("gap").integer(0, texture_limits::largestPageSize));
    atlas->options.layout = AtlasLayout::MatchedRows; // as far as a package tells: undistorted
    if (texture.has("layout")) {
        const auto layout = fromWord<AtlasLayout>(texture.member("layout").text());
        if (layout && isStretched(*layout))
            atlas->options.layout = *layout;
        else
            texture.member("layout").addProblem("should be \"charts\" or \"own\" where it is told");
    }
    for (const std::string& problem : validate(atlas->options))
        texture.addProblem("is not usable: " + problem);
    atlas->texelsPerMetre = texture.member("texelsPerMetre").number();
    atlas->utilisation = texture.member("utilisation").number();
    atlas->corners.resize(triangles);
    atlas->page.resize(triangles);
    return atlas;
}

void DrawnReader::read(const JsonReader& extension, ModelPackage& package) const {
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
        primitives.push_back(part.primitive);
        if (atlas) placePart(drawn[page], part, page, *atlas);
    }
    if (std::any_of(timesDrawn.begin(), timesDrawn.end(), [](int times) { return times != 1; }))
        extension.member("drawn").addProblem("should show every triangle of the surface once");
    package.atlas = atlas;
    if (m_problems.empty() && atlas) readPages(primitives, package);
    if (m_problems.empty()) readFinish(primitives, package);
}

} // namespace

void readDrawn(const JsonReader& extension, const GltfArrayReader& arrays, std::vector<std::string>& problems,
               ModelPackage& package) {
    const DrawnReader reader(arrays, problems);
    reader.read(extension, package);
    if (extension.has("preview")) package.preview = reader.readPreview(extension.member("preview"));
}

} // namespace esm
