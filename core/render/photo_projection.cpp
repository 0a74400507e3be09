#include "core/render/photo_projection.h"

#include "core/render/drawn_shape.h"
#include "core/render/shaders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace esm {
namespace {

constexpr double nearestShare = 1.0 / 2000; ///< of the farthest depth, where an eye stands in the organ

bool isPerspective(const ProjectedPhoto& projected) {
    return projected.projector.kind == ProjectorKind::Perspective;
}

/// Colours weighed by alpha, so that filters mix in nothing of what is transparent (Porter and Duff 1984);
/// the shader divides it out again.
Image premultiplied(Image weighed) {
    for (std::size_t i = 0; i < weighed.pixels.size(); i += 4) {
        const unsigned alpha = weighed.pixels[i + 3];
        if (alpha == 255) continue;
        for (std::size_t channel = 0; channel < 3; ++channel)
            weighed.pixels[i + channel] =
                static_cast<std::uint8_t>((weighed.pixels[i + channel] * alpha + 127) / 255);
    }
    return weighed;
}

/// How much has faded, a pixel for each node.
Image pictureOf(const PhotoFade& fade) {
    Image picture{std::max(1, fade.columns), std::max(1, fade.rows), {}};
    picture.pixels.assign(
        4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 0);
    for (std::size_t i = 0; i < fade.faded.size(); ++i)
        picture.pixels[4 * i] = static_cast<std::uint8_t>(std::lround(255 * fade.faded[i]));
    return picture;
}

/// Of parts that are seen from different sides each is coloured from both.
SeenSide commonSide(const std::vector<SeenSide>& sides) {
    const bool isOne = std::adjacent_find(sides.begin(), sides.end(), std::not_equal_to<>()) == sides.end();
    return isOne && !sides.empty() ? sides.front() : SeenSide::Both;
}

/// Pixels of the picture across the photo's longer side where it meets the organ's middle; endless from
/// within the organ.
double pixelsAcross(const ProjectedPhoto& projected, const Frame& frame) {
    const PhotoSize photo = sizeOf(*projected.photo);
    const Projector& projector = projected.projector;
    const double depth = photoMatrix(projector, photo).row(3).dot(frame.origin.homogeneous());
    const double metresPerPhotoPixel =
        isPerspective(projected) ? depth / intrinsicsOf(projector, photo).fx : projector.width / photo.width;
    const double away = (frame.projection * frame.view).col(3).w(); // of the middle; 1 without perspective
    if (!(depth > 0) || !(away > 0)) return std::numeric_limits<double>::infinity();
    const double pixelsPerMetre = 0.5 * frame.pixels.y() * frame.projection(1, 1) / away;
    return std::max(photo.width, photo.height) * metresPerPhotoPixel * pixelsPerMetre;
}

/// Pixels of the depth map's longer side: about those of the picture, as drawing without a graphics card goes
/// by them, in few steps, as each is drawn anew.
int mapSizeFor(double pixels) {
    constexpr int smallest = 256, largest = 1024;
    constexpr double nearer = 1.5; // parts of the surface than its middle
    int size = smallest;
    while (size < largest && size < nearer * pixels)
        size *= 2;
    return size;
}

} // namespace

GlDepthMap::GlDepthMap(const GlFunctions& gl) : m_gl(gl) {
    m_gl.GenTextures(1, &m_texture);
    m_gl.GenFramebuffers(1, &m_target);
}

GlDepthMap::~GlDepthMap() {
    m_gl.DeleteFramebuffers(1, &m_target);
    m_gl.DeleteTextures(1, &m_texture);
}

void GlDepthMap::begin(int width, int height) {
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_target);
    if (width != m_width || height != m_height) {
        bind(0);
        m_gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width, height, 0, GL_DEPTH_COMPONENT,
                        GL_UNSIGNED_INT, nullptr);
        for (const GLenum filter : std::array<GLenum, 2>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            m_gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
        for (const GLenum wrap : std::array<GLenum, 2>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            m_gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
        m_gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_texture, 0);
        m_gl.DrawBuffer(GL_NONE);
        m_gl.ReadBuffer(GL_NONE);
        m_width = width;
        m_height = height;
    }
    m_gl.Viewport(0, 0, width, height);
    m_gl.DepthMask(GL_TRUE);
    m_gl.Disable(GL_SCISSOR_TEST);
    m_gl.Clear(GL_DEPTH_BUFFER_BIT);
}

void GlDepthMap::bind(int unit) const {
    m_gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    m_gl.BindTexture(GL_TEXTURE_2D, m_texture);
}

PhotoProjection::PhotoProjection(const GlFunctions& gl)
    : m_gl(gl), m_depthProgram(gl, shaders::photoDepthVertex(), shaders::photoDepthFragment()),
      m_vertexBuffer(gl), m_indexBuffer(gl), m_vertexTexture(gl), m_array(gl), m_seen(gl), m_fadeTexture(gl),
      m_bandTexture(gl) {
    m_array.bind();
    m_indexBuffer.bind(GL_ELEMENT_ARRAY_BUFFER);
}

/// A shadow map (Williams 1978, Casting curved shadows on curved surfaces): the organ is drawn once from the
/// projector, depth alone, and a pixel on the screen is lit where it lies no deeper than that map says.
/// Composing follows rays, which is exact and takes too long for each picture of a drag. The map is drawn
/// anew only where photo, projector or surface are others, or its size.
void PhotoProjection::take(const ProjectedPhoto& projected, const std::shared_ptr<const TriangleMesh>& mesh,
                           const Frame& frame) {
    const bool isKnown = m_projected && mesh == m_mesh && projected.photo == m_photo &&
                         projected.projector == m_projected->projector &&
                         projected.blendPixels == m_projected->blendPixels &&
                         projected.fadesAtMask == m_projected->fadesAtMask;
    takeMesh(mesh, frame);
    takePhoto(projected.photo);
    takeBands(projected.bands);
    m_projected = projected;
    Eigen::Matrix4d fromOrigin = Eigen::Matrix4d::Identity();
    fromOrigin.topRightCorner<3, 1>() = frame.origin;
    m_matrix = photoMatrix(projected.projector, sizeOf(*projected.photo)) * fromOrigin;
    m_tolerance = hidingTolerance(*mesh);
    const Eigen::Isometry3d& pose = projected.projector.pose;
    const Eigen::Vector3f light = isPerspective(projected) ? frame.local(pose.translation())
                                                           : pose.linear().col(2).cast<float>().eval();
    m_light = {light.x(), light.y(), light.z(), isPerspective(projected) ? 1.0F : 0.0F};
    if (!isKnown) takeFade();
    const int mapSize = mapSizeFor(pixelsAcross(projected, frame));
    if (!projected.projector.occlusion || (isKnown && mapSize == m_mapSize)) return;
    m_mapSize = mapSize;
    measureDepth();
    drawDepth();
}

/// At rest: photos are projected onto the organ as it was when they were placed, and go along with the tissue
/// as it moves.
void PhotoProjection::takeMesh(const std::shared_ptr<const TriangleMesh>& mesh, const Frame& frame) {
    if (mesh == m_mesh) return;
    m_mesh = mesh;
    m_cache = {};
    const auto normals = m_cache.normalsOf(*mesh);
    std::vector<Eigen::Vector4f> texels; // place, normal, place …
    texels.reserve(2 * mesh->vertices.size());
    for (std::size_t i = 0; i < mesh->vertices.size(); ++i) {
        texels.push_back(frame.local(mesh->vertices[i]).homogeneous());
        texels.push_back((*normals)[i].cast<float>().homogeneous());
    }
    m_vertexBuffer.upload(GL_TEXTURE_BUFFER, texels.data(), texels.size() * sizeof(texels[0]),
                          GL_STATIC_DRAW);
    m_vertexTexture.attach(m_vertexBuffer);
    m_array.bind();
    m_indexBuffer.upload(GL_ELEMENT_ARRAY_BUFFER, mesh->triangles.data(),
                         mesh->triangles.size() * sizeof(Triangle), GL_STATIC_DRAW);
}

void PhotoProjection::takePhoto(const std::shared_ptr<const Image>& photo) {
    if (photo == m_photo) return;
    m_photo = photo;
    m_photoTexture = std::make_unique<GlTexture>(m_gl);
    const Image shown = premultiplied(shrunk(*photo, largestDrawnPhoto));
    m_photoTexture->upload(shown, static_cast<int>(std::log2(std::max(shown.width, shown.height))));
}

void PhotoProjection::takeBands(const std::shared_ptr<const Image>& bands) {
    if (bands == m_bands) return;
    m_bands = bands;
    if (bands) m_bandTexture.upload(*bands, 0);
}

/// The same as composing has, so that nothing changes when the drag ends.
void PhotoProjection::takeFade() {
    m_side = commonSide(m_cache.sidesOf(m_projected->projector, *m_mesh));
    const auto before = m_fade;
    m_fade = m_cache.fadeOf(
        {m_projected->projector, m_photo, m_projected->blendPixels, m_projected->fadesAtMask}, *m_mesh, {});
    m_cache.finish();
    if (m_fade && m_fade != before) m_fadeTexture.upload(pictureOf(*m_fade), 0);
}

/// What lies between the projector and the farthest of the organ, no more: depth is only so fine. Before an
/// eye it goes as 1 / z: a near plane closer than a 2000th of the far one, as for an eye within the organ,
/// would leave nothing of it for what lies farther off.
void PhotoProjection::measureDepth() {
    const Eigen::Matrix4d inModel = photoMatrix(m_projected->projector, sizeOf(*m_photo));
    double least = std::numeric_limits<double>::max(), most = 0;
    for (const Eigen::Vector3d& vertex : m_mesh->vertices) {
        const double depth = inModel.row(3) * vertex.homogeneous();
        least = std::min(least, depth);
        most = std::max(most, depth);
    }
    m_far = std::max(most * 1.001, m_tolerance) + m_tolerance;
    m_near = isPerspective(*m_projected) ? std::max(0.5 * least, nearestShare * m_far) : -m_tolerance;
}

void PhotoProjection::drawDepth() {
    const int longer = std::max(m_photo->width, m_photo->height);
    const auto sideOf = [&](int pixels) { return std::max(1, m_mapSize * pixels / longer); };
    m_seen.render(sideOf(m_photo->width), sideOf(m_photo->height), [&] {
        m_gl.Enable(GL_DEPTH_TEST);
        m_gl.DepthFunc(GL_LESS);
        m_gl.Disable(GL_CULL_FACE);
        m_gl.Enable(GL_POLYGON_OFFSET_FILL);
        m_gl.PolygonOffset(2, 2); // steep surface covers a range of depths within a pixel
        m_depthProgram.use();
        bind(m_depthProgram);
        m_array.bind();
        m_gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * m_mesh->triangles.size()), GL_UNSIGNED_INT,
                          nullptr);
        m_gl.Disable(GL_POLYGON_OFFSET_FILL);
        m_gl.Disable(GL_DEPTH_TEST);
    });
}

void PhotoProjection::bind(const GlProgram& program) const {
    program.set("intoPhoto", Eigen::Matrix4f(m_matrix.cast<float>()));
    program.set("photoPixels", Eigen::Vector2f(float(m_photo->width), float(m_photo->height)));
    program.set("depths", Eigen::Vector2f(float(m_near), float(m_far)));
    program.set("isPerspective", isPerspective(*m_projected));
    program.set("light", m_light);
    program.set("tolerance", static_cast<float>(m_tolerance));
    program.set("occlusion", m_projected->projector.occlusion);
    program.set("seenSide", static_cast<int>(m_side));
    program.set("falloff", m_projected->projector.falloff);
    program.set("blendPixels", static_cast<float>(m_projected->blendPixels));
    program.set("opacity", static_cast<float>(m_projected->opacity));
    program.set("blending", static_cast<int>(m_projected->blending));
    program.set("restVertices", 2);
    program.set("photo", 3);
    program.set("seen", 4);
    program.set("fade", 5);
    program.set("bands", 6);
    program.set("hasBands", m_bands != nullptr);
    program.set("fadeNodes", m_fade ? Eigen::Vector2f(float(m_fade->columns), float(m_fade->rows))
                                    : Eigen::Vector2f(0, 0));
    program.set("fadeSpacing", m_fade ? float(m_fade->spacing) : 1.0F);
    m_vertexTexture.bind(GL_TEXTURE_BUFFER, 2);
    m_photoTexture->bind(GL_TEXTURE_2D, 3);
    m_seen.bind(4);
    m_fadeTexture.bind(GL_TEXTURE_2D, 5);
    m_bandTexture.bind(GL_TEXTURE_2D, 6);
}

} // namespace esm
