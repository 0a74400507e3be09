#include "core/render/marker_drawer.h"

#include "core/render/drawn_shape.h"
#include "core/render/shaders.h"
#include "core/support/angles.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector4f;

constexpr Colour amber{227, 163, 59};
constexpr Colour steel{154, 164, 173};
constexpr std::uint32_t ballRings = 32, ballSectors = 48;

std::vector<Vector3f> ballPoints() {
    std::vector<Vector3f> points;
    for (std::uint32_t ring = 0; ring <= ballRings; ++ring) {
        const float polar = float(pi) * float(ring) / float(ballRings);
        for (std::uint32_t sector = 0; sector <= ballSectors; ++sector) {
            const float around = 2 * float(pi) * float(sector) / float(ballSectors);
            points.emplace_back(std::sin(polar) * std::sin(around), std::cos(polar),
                                std::sin(polar) * std::cos(around));
        }
    }
    return points;
}

std::vector<std::uint32_t> ballTriangles() {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t ring = 0; ring < ballRings; ++ring)
        for (std::uint32_t sector = 0; sector < ballSectors; ++sector) {
            const std::uint32_t here = ring * (ballSectors + 1) + sector, below = here + ballSectors + 1;
            indices.insert(indices.end(), {here, below, here + 1, here + 1, below, below + 1});
        }
    return indices;
}

bool isDrawableShape(const Ellipsoid& ellipsoid) {
    return isDrawable(ellipsoid.centre) && isDrawable(ellipsoid.radii) && ellipsoid.radii.minCoeff() > 0 &&
           ellipsoid.orientation.coeffs().allFinite();
}

/// Nothing where it cannot be drawn.
std::optional<Ellipsoid> ballOf(const DrawnSphere& sphere) {
    Ellipsoid ball;
    ball.centre = sphere.centre;
    ball.radii.setConstant(sphere.radius);
    return isDrawableShape(ball) ? std::optional(ball) : std::nullopt;
}

bool isDrawableShape(const DrawnProjector& drawn, const Eigen::AlignedBox3d& shown) {
    const std::array<Vector3d, 8> corners = projectorBox(drawn, shown);
    return std::all_of(corners.begin(), corners.end(), isDrawable);
}

std::array<std::uint8_t, 4> withAlpha(const Colour& colour, std::uint8_t alpha) {
    return {colour[0], colour[1], colour[2], alpha};
}

Vector4f withAlpha(const Colour& colour, float alpha) {
    const Vector3f rgb = toFloat(colour);
    return {rgb.x(), rgb.y(), rgb.z(), alpha};
}

/// Once the photo lies on the organ, the face is the slide it is thrown from: not the same picture once more.
Vector4f facePaint(const DrawnProjector& drawn) {
    if (drawn.isLaid) return {1, 0.86F, 0.62F, 0.24F};
    return {1, 1, 1, drawn.selected ? 0.55F : 0.35F};
}

} // namespace

/// Lines gathered over several shapes and drawn at once.
struct MarkerDrawer::Curves {
    std::vector<Vector3d> points;
    std::vector<Segment> segments;

    void add(const std::vector<Vector3d>& loop, const std::array<std::uint8_t, 4>& paint, float width) {
        const auto first = static_cast<std::uint32_t>(points.size());
        const auto count = static_cast<std::uint32_t>(loop.size());
        points.insert(points.end(), loop.begin(), loop.end());
        for (std::uint32_t i = 0; i < count; ++i)
            segments.push_back({first + i, first + (i + 1) % count, paint, width});
    }

    /// Two thirds of the loop.
    void addBroken(const std::vector<Vector3d>& loop, const std::array<std::uint8_t, 4>& paint, float width) {
        const std::size_t start = segments.size();
        add(loop, paint, width);
        std::size_t place = 0;
        segments.erase(std::remove_if(segments.begin() + static_cast<std::ptrdiff_t>(start), segments.end(),
                                      [&](const Segment&) { return place++ % 3 == 2; }),
                       segments.end());
    }

    void addBox(const std::array<Vector3d, 8>& corners, bool selected) {
        const std::uint8_t alpha = selected ? 255 : 150;
        add({corners.begin(), corners.begin() + 4}, withAlpha(amber, alpha), selected ? 2.2F : 1.4F);
        add({corners.begin() + 4, corners.end()}, withAlpha(amber, alpha), selected ? 1.2F : 0.8F);
        for (std::size_t i = 0; i < 4; ++i)
            add({corners[i], corners[i + 4]}, withAlpha(amber, alpha), selected ? 1.2F : 0.8F);
    }
};

MarkerDrawer::MarkerDrawer(const GlFunctions& gl)
    : m_gl(gl), m_steel(gl, shaders::ballVertex(), shaders::steelFragment()),
      m_shell(gl, shaders::ballVertex(), shaders::shellFragment()),
      m_quad(gl, shaders::quadVertex(), shaders::quadFragment()), m_ballVertices(gl), m_ballIndices(gl),
      m_ball(gl), m_emptyArray(gl), m_curvePoints(gl), m_curveSegments(gl) {
    const std::vector<Vector3f> points = ballPoints();
    const std::vector<std::uint32_t> triangles = ballTriangles();
    m_ballIndexCount = static_cast<GLsizei>(triangles.size());
    m_ball.bind();
    m_ballVertices.upload(GL_ARRAY_BUFFER, points.data(), points.size() * sizeof(Vector3f), GL_STATIC_DRAW);
    m_ballIndices.upload(GL_ELEMENT_ARRAY_BUFFER, triangles.data(), triangles.size() * sizeof(std::uint32_t),
                         GL_STATIC_DRAW);
    m_ball.addFloats(0, 3, sizeof(Vector3f), 0);
}

void MarkerDrawer::drawInstrument(const DrawnSphere& sphere, const Frame& frame) const {
    const std::optional<Ellipsoid> ball = ballOf(sphere);
    if (!ball) return;
    m_steel.use();
    m_steel.set("baseColour", toFloat(steel));
    drawBall(m_steel, *ball, frame);
}

/// It acts inside the organ too: what the surface hides of it stays in sight.
void MarkerDrawer::drawHiddenInstrument(const DrawnSphere& sphere, const Frame& frame) const {
    const std::optional<Ellipsoid> ball = ballOf(sphere);
    if (!ball) return;
    m_shell.use();
    m_shell.set("baseColour", toFloat(steel));
    m_shell.set("opacity", 0.55F);
    m_gl.Enable(GL_CULL_FACE);
    m_gl.DepthFunc(GL_GREATER);
    drawBall(m_shell, *ball, frame);
    m_gl.DepthFunc(GL_LEQUAL);
    m_gl.Disable(GL_CULL_FACE);
}

/// Everything here is blended and writes no depth, so its order is that of drawing: glass first, lines over
/// it, outlines last.
void MarkerDrawer::drawTransparent(const RenderScene& scene, const Eigen::AlignedBox3d& shown,
                                   const LineDrawer& lines, const Frame& frame) {
    if (scene.instrument) drawHiddenInstrument(*scene.instrument, frame);
    Curves curves, outlines;
    for (const DrawnProjector& drawn : scene.projectors) {
        if (!isDrawableShape(drawn, shown)) continue;
        drawBoxFaces(drawn, shown, frame);
        curves.addBox(projectorBox(drawn, shown), drawn.selected);
    }
    for (const DrawnEllipsoid& drawn : scene.ellipsoids) {
        if (!isDrawableShape(drawn.shape)) continue;
        drawShell(drawn, frame);
        const auto paint = withAlpha(drawn.colour, drawn.selected ? std::uint8_t{170} : std::uint8_t{90});
        for (const int axis : {0, 1, 2})
            curves.add(greatCircle(drawn.shape, axis), paint, drawn.selected ? 1.3F : 1.0F);
        const auto outline = withAlpha(drawn.colour, drawn.selected ? std::uint8_t{255} : std::uint8_t{170});
        outlines.add(silhouette(drawn.shape, frame.eye), outline, drawn.selected ? 2.2F : 1.3F);
        if (drawn.rim > 0 && isDrawable({drawn.rim, 0, 0}))
            outlines.addBroken(rimSilhouette(drawn.shape, drawn.rim, frame.eye), outline,
                               drawn.selected ? 1.6F : 1.0F);
    }
    // What the organ hides shows through faintly, so that shape and place can be read at a glance.
    m_gl.Disable(GL_DEPTH_TEST);
    drawCurves(curves, {0.22F, 0, false}, lines, frame);
    drawCurves(outlines, {1, 0, false}, lines, frame);
    m_gl.Enable(GL_DEPTH_TEST);
    drawCurves(curves, {1, 0, false}, lines, frame);
    const auto isUnused = [&](const auto& entry) {
        return std::none_of(scene.projectors.begin(), scene.projectors.end(),
                            [&](const DrawnProjector& drawn) { return drawn.photo == entry.first; });
    };
    for (auto entry = m_photos.begin(); entry != m_photos.end();)
        entry = isUnused(*entry) ? m_photos.erase(entry) : std::next(entry);
}

void MarkerDrawer::drawShell(const DrawnEllipsoid& ellipsoid, const Frame& frame) const {
    m_shell.use();
    m_shell.set("baseColour", toFloat(ellipsoid.colour));
    m_shell.set("opacity", ellipsoid.selected ? 0.20F : 0.09F);
    m_gl.Enable(GL_CULL_FACE);
    drawBall(m_shell, ellipsoid.shape, frame);
    m_gl.Disable(GL_CULL_FACE);
}

void MarkerDrawer::drawBall(const GlProgram& program, const Ellipsoid& ellipsoid, const Frame& frame) const {
    Eigen::Matrix4f model = Eigen::Matrix4f::Identity();
    model.topLeftCorner<3, 3>() =
        (ellipsoid.orientation.toRotationMatrix() * ellipsoid.radii.asDiagonal()).cast<float>();
    model.topRightCorner<3, 1>() = frame.local(ellipsoid.centre);
    program.set("model", model);
    program.set("view", frame.view);
    program.set("projection", frame.projection);
    m_ball.bind();
    m_gl.DrawElements(GL_TRIANGLES, m_ballIndexCount, GL_UNSIGNED_INT, nullptr);
}

void MarkerDrawer::drawBoxFaces(const DrawnProjector& drawn, const Eigen::AlignedBox3d& shown,
                                const Frame& frame) {
    const std::array<Vector3d, 8> corners = projectorBox(drawn, shown);
    const Vector4f glass = withAlpha(amber, drawn.selected ? 0.06F : 0.03F);
    drawQuad({corners[4], corners[5], corners[7], corners[6]}, glass, nullptr, frame);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        drawQuad({corners[i], corners[next], corners[i + 4], corners[next + 4]}, glass, nullptr, frame);
    }
    const GlTexture* photo = photoTexture(drawn.photo);
    drawQuad({corners[0], corners[1], corners[3], corners[2]}, photo ? facePaint(drawn) : glass, photo,
             frame);
}

void MarkerDrawer::drawQuad(const std::array<Vector3d, 4>& corners, const Vector4f& paint,
                            const GlTexture* photo, const Frame& frame) const {
    m_quad.use();
    m_quad.set("view", frame.view);
    m_quad.set("projection", frame.projection);
    m_quad.set("tint", paint);
    m_quad.set("textured", photo != nullptr);
    m_quad.set("page", 1);
    if (photo) photo->bind(GL_TEXTURE_2D, 1);
    constexpr std::array<const char*, 4> names{"corners[0]", "corners[1]", "corners[2]", "corners[3]"};
    for (std::size_t i = 0; i < 4; ++i)
        m_quad.set(names[i], frame.local(corners[i]));
    m_emptyArray.bind();
    m_gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void MarkerDrawer::drawCurves(const Curves& curves, const LineStyle& style, const LineDrawer& lines,
                              const Frame& frame) {
    if (curves.segments.empty()) return;
    m_curvePoints.upload(curves.points, frame);
    m_curveSegments.upload(curves.segments);
    lines.draw(m_curvePoints, m_curveSegments, style, frame);
}

const GlTexture* MarkerDrawer::photoTexture(const std::shared_ptr<const Image>& photo) {
    if (!photo || photo->empty()) return nullptr;
    std::unique_ptr<GlTexture>& texture = m_photos[photo];
    if (!texture) {
        constexpr int photoLevels = 4;
        texture = std::make_unique<GlTexture>(m_gl);
        texture->upload(*photo, photoLevels);
    }
    return texture.get();
}

} // namespace esm
