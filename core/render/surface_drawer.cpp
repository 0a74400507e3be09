#include "core/render/surface_drawer.h"

#include "core/render/drawn_shape.h"
#include "core/render/shaders.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace esm {
namespace {

struct Corner {
    std::uint32_t vertex;
    std::array<float, 6> patch; ///< u and v of the whole triangle's corners
};

bool isTextured(const RenderScene& scene) {
    return scene.atlas && scene.texturePages && scene.atlas->corners.size() == scene.mesh->triangles.size() &&
           scene.atlas->page.size() == scene.mesh->triangles.size();
}

constexpr int finishUnit = 7; ///< behind those of a projected photo

/// What tissue is taken for in an endoscope's light where nobody said.
constexpr SurfaceFinish usualFinish{0.45, 0.5};

int levelsOf(const std::shared_ptr<const SmallerPages>& smallerPages) {
    return smallerPages && !smallerPages->empty() ? static_cast<int>(smallerPages->front().size()) : 0;
}

} // namespace

SurfaceDrawer::SurfaceDrawer(const GlFunctions& gl)
    : m_gl(gl), m_vertexBuffer(gl), m_indexBuffer(gl), m_cornerBuffer(gl), m_vertexTexture(gl),
      m_plainArray(gl), m_texturedArray(gl) {
    m_plainArray.bind();
    m_indexBuffer.bind(GL_ELEMENT_ARRAY_BUFFER);
    m_texturedArray.bind();
    m_cornerBuffer.bind(GL_ARRAY_BUFFER);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribIPointer(0, 1, GL_UNSIGNED_INT, sizeof(Corner), nullptr);
    constexpr std::size_t textureCoordinates = 2 * sizeof(float);
    for (GLuint i = 0; i < 3; ++i)
        m_texturedArray.addFloats(1 + i, 2, sizeof(Corner), offsetof(Corner, patch) + i * textureCoordinates);
}

void SurfaceDrawer::draw(const RenderScene& scene, const std::vector<Eigen::Vector3d>& vertices,
                         const Frame& frame, const PhotoProjection* photo) {
    if (!scene.mesh || scene.mesh->triangles.empty()) return;
    const bool textured = isTextured(scene);
    takeTriangles(scene.mesh);
    takeVertices(scene, vertices, frame);
    const GlProgram& program =
        programFor({photo != nullptr, scene.finish || scene.light == SceneLight::Endoscope});
    program.use();
    if (photo) photo->bind(program);
    program.set("view", frame.view);
    program.set("projection", frame.projection);
    program.set("baseColour", toFloat(scene.baseColour));
    program.set("unlit", scene.unlit);
    program.set("cut", frame.cut);
    program.set("plainInside", scene.cut.has_value());
    program.set("tinted", scene.nodePaint != nullptr);
    program.set("perCorner", textured);
    program.set("vertices", 0);
    program.set("page", 1);
    setFinish(program, scene, frame);
    m_vertexTexture.bind(GL_TEXTURE_BUFFER, 0);
    if (hidesItsInside(scene, frame)) m_gl.Enable(GL_CULL_FACE);
    if (textured) {
        takeAtlas(scene.atlas);
        takePages(scene);
        takeFinish(scene.finishPages);
        program.set("pageSize", static_cast<float>(scene.atlas->options.size));
        program.set("halfGap", static_cast<float>(filledGap(scene.atlas->options) / 2));
        program.set("levels", levelsOf(scene.smallerPages));
        m_vertexTexture.bind(GL_TEXTURE_BUFFER, 0);
        drawPages(program, photo && scene.projectedPhoto->isMasked);
    } else {
        drawPlain(program);
    }
    m_gl.Disable(GL_CULL_FACE);
}

const GlProgram& SurfaceDrawer::programFor(const shaders::SurfaceParts& parts) {
    for (const auto& [made, program] : m_programs)
        if (made == parts) return *program;
    m_programs.emplace_back(parts, std::make_unique<GlProgram>(m_gl, shaders::surfaceVertex(parts),
                                                               shaders::surfaceFragment(parts)));
    return *m_programs.back().second;
}

void SurfaceDrawer::setFinish(const GlProgram& program, const RenderScene& scene, const Frame& frame) {
    const SurfaceFinish plain = scene.finish.value_or(usualFinish);
    program.set("finishPage", finishUnit);
    program.set("plainFinish",
                Eigen::Vector2f(static_cast<float>(plain.wetness), static_cast<float>(plain.roughness)));
    program.set("endoscope", scene.light == SceneLight::Endoscope);
    program.set("exposedDistance", frame.exposedDistance);
    program.set("filmRoughness", static_cast<float>(filmRoughness));
}

/// From outside, every line of sight through a closed surface meets a front before a back, so half the
/// triangles need no drawing.
bool SurfaceDrawer::hidesItsInside(const RenderScene& scene, const Frame& frame) const {
    if (scene.cut) return false;
    constexpr double margin = 0.02; // of the organ's size, for what the near plane may cut
    const Eigen::AlignedBox3d box = boundingBox(m_vertices);
    const Eigen::Vector3d grown = Eigen::Vector3d::Constant(margin * box.diagonal().norm());
    return m_closed && !Eigen::AlignedBox3d(box.min() - grown, box.max() + grown).contains(frame.eye);
}

void SurfaceDrawer::drawPlain(const GlProgram& program) const {
    program.set("painted", false);
    program.set("masked", false);
    program.set("finishPainted", false);
    m_plainArray.bind();
    m_gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * m_mesh->triangles.size()), GL_UNSIGNED_INT,
                      nullptr);
}

void SurfaceDrawer::drawPages(const GlProgram& program, bool areMasked) const {
    m_texturedArray.bind();
    for (const PageRange& range : m_ranges) {
        const bool known = range.page < m_pageTextures.size() && m_pageTextures[range.page];
        program.set("painted", known);
        program.set("masked", known && areMasked);
        if (known) m_pageTextures[range.page]->bind(GL_TEXTURE_2D, 1);
        const bool hasFinish = range.page < m_finishTextures.size();
        program.set("finishPainted", hasFinish);
        if (hasFinish) m_finishTextures[range.page]->bind(GL_TEXTURE_2D, finishUnit);
        m_gl.DrawArrays(GL_TRIANGLES, range.first, range.count);
    }
}

void SurfaceDrawer::takeTriangles(const std::shared_ptr<const TriangleMesh>& mesh) {
    if (mesh == m_mesh) return;
    m_mesh = mesh;
    m_closed = isSolid(*mesh);
    m_atlas.reset();
    m_vertices.clear();
    m_plainArray.bind();
    m_indexBuffer.upload(GL_ELEMENT_ARRAY_BUFFER, mesh->triangles.data(),
                         mesh->triangles.size() * sizeof(Triangle), GL_STATIC_DRAW);
}

/// Positions and normals lie in a texture that shaders read by number: what moves is uploaded once per vertex
/// and not six times, once for each triangle around it.
void SurfaceDrawer::takeVertices(const RenderScene& scene, const std::vector<Eigen::Vector3d>& vertices,
                                 const Frame& frame) {
    if (vertices == m_vertices && scene.nodePaint == m_nodePaint) return;
    const std::vector<Paint> paint = vertexPaint(scene, vertices.size());
    if (vertices != m_vertices) {
        const std::vector<Eigen::Vector3d> normals = vertexNormals(vertices, m_mesh->triangles);
        m_texels.resize(vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Eigen::Vector3f place = frame.local(vertices[i]), normal = normals[i].cast<float>();
            m_texels[i] = {place.x(), place.y(), place.z(), 0, normal.x(), normal.y(), normal.z(), 0};
        }
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto& [red, green, blue, cover] = paint.empty() ? Paint{} : paint[i];
        m_texels[i][3] = static_cast<float>((red << 16) | (green << 8) | blue); // 24 bits are exact
        m_texels[i][7] = static_cast<float>(cover) / 255;
    }
    m_vertexBuffer.upload(GL_TEXTURE_BUFFER, m_texels.data(), m_texels.size() * sizeof(m_texels[0]),
                          GL_STREAM_DRAW);
    m_vertexTexture.attach(m_vertexBuffer);
    m_vertices = vertices;
    m_nodePaint = scene.nodePaint;
}

/// Triangles sorted by their pages, so that each page is bound once; stably, so that within a page the mesh's
/// order, in which neighbours are near each other in memory, is kept. A vertex has another place in the
/// texture in each triangle around it, so corners are not shared; they hold the number of a vertex whose
/// position all share.
void SurfaceDrawer::takeAtlas(const std::shared_ptr<const Atlas>& atlas) {
    if (atlas == m_atlas) return;
    m_atlas = atlas;
    std::vector<std::size_t> order(m_mesh->triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return atlas->page[a] < atlas->page[b]; });
    std::vector<Corner> corners;
    corners.reserve(3 * order.size());
    m_ranges.clear();
    for (const std::size_t triangle : order) {
        const std::size_t page = atlas->page[triangle];
        if (m_ranges.empty() || m_ranges.back().page != page)
            m_ranges.push_back({page, static_cast<GLint>(corners.size()), 0});
        m_ranges.back().count += 3;
        std::array<float, 6> patch;
        for (std::size_t i = 0; i < 6; ++i)
            patch[i] = static_cast<float>(atlas->corners[triangle][i / 2][static_cast<Eigen::Index>(i % 2)] /
                                          atlas->options.size);
        for (const std::uint32_t vertex : m_mesh->triangles[triangle])
            corners.push_back({vertex, patch});
    }
    m_cornerBuffer.upload(GL_ARRAY_BUFFER, corners.data(), corners.size() * sizeof(Corner), GL_STATIC_DRAW);
}

void SurfaceDrawer::takePages(const RenderScene& scene) {
    if (scene.texturePages == m_pages && scene.smallerPages == m_smallerPages) return;
    m_pages = scene.texturePages;
    m_smallerPages = scene.smallerPages;
    m_pageTextures.resize(m_pages->size());
    for (std::size_t i = 0; i < m_pages->size(); ++i) {
        const TiledImage& page = (*m_pages)[i];
        std::unique_ptr<GlTexture>& texture = m_pageTextures[i];
        if (page.empty()) {
            texture.reset();
            continue;
        }
        if (!texture) texture = std::make_unique<GlTexture>(m_gl);
        const bool hasSmaller = m_smallerPages && i < m_smallerPages->size();
        texture->upload(page, hasSmaller ? (*m_smallerPages)[i] : std::vector<TiledImage>());
    }
}

/// No smaller copies: a mean of normals is no normal, and it would blur reflections, which stay sharp from
/// afar.
void SurfaceDrawer::takeFinish(const std::shared_ptr<const TiledPages>& pages) {
    if (pages == m_finishPages) return;
    m_finishPages = pages;
    m_finishTextures.resize(pages ? pages->size() : 0);
    for (std::size_t i = 0; i < m_finishTextures.size(); ++i) {
        if (!m_finishTextures[i]) m_finishTextures[i] = std::make_unique<GlTexture>(m_gl);
        m_finishTextures[i]->upload((*pages)[i], {});
    }
}

} // namespace esm
