#include "core/render/marker_drawer.h"

#include "core/render/drawn_shape.h"
#include "core/render/shaders.h"
#include "core/support/angles.h"
#include "core/texture/photo/photo_sampler.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector4f;

constexpr Colour amber{227, 163, 59};
constexpr Colour steel{154, 164, 173};
constexpr std::uint32_t ballRings = 32, ballRows = ballRings + 2, ballSectors = 48;

/// A point of the unit ball, and the half that it belongs to.
struct BallPoint {
    Vector3f unit;
    float side; ///< 1 and -1
};

/// Both halves have an equator of their own, so that a capsule's cylinder comes between them.
std::vector<BallPoint> ballPoints() {
    std::vector<BallPoint> points;
    for (std::uint32_t row = 0; row < ballRows; ++row) {
        const bool isUpper = row <= ballRings / 2;
        const float polar = float(pi) * float(isUpper ? row : row - 1) / float(ballRings);
        for (std::uint32_t sector = 0; sector <= ballSectors; ++sector) {
            const float around = 2 * float(pi) * float(sector) / float(ballSectors);
            points.push_back(
                {{std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around)},
                 isUpper ? 1.0F : -1.0F});
        }
    }
    return points;
}

std::vector<std::uint32_t> ballTriangles() {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t row = 0; row + 1 < ballRows; ++row)
        for (std::uint32_t sector = 0; sector < ballSectors; ++sector) {
            const std::uint32_t here = row * (ballSectors + 1) + sector, below = here + ballSectors + 1;
            indices.insert(indices.end(), {here, below, here + 1, here + 1, below, below + 1});
        }
    return indices;
}

bool isDrawableShape(const Ellipsoid& ellipsoid) {
    return isDrawable(ellipsoid.centre) && isDrawable(ellipsoid.radii) && ellipsoid.radii.minCoeff() > 0 &&
           ellipsoid.orientation.coeffs().allFinite();
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

/// Once the photo lies on the organ, the face is the slide it is projected from: not the same picture once
/// more.
Vector4f facePaint(const DrawnProjector& drawn) {
    const auto cover = static_cast<float>(drawn.cover);
    return drawn.isLaid ? Vector4f(1, 0.86F, 0.62F, cover) : Vector4f(1, 1, 1, cover);
}

} // namespace

/// An ellipsoid whose halves stand apart along its y axis.
struct MarkerDrawer::Ball {
    Ellipsoid shape;
    double apart = 0; ///< m, from the middle

    /// Nothing where it cannot be drawn.
    static std::optional<Ball> of(const PlacedCollider& collider) {
        const double radius = radiusOf(collider.shape);
        // A capsule lies along z, the ball's poles along y.
        const Eigen::Quaterniond towards =
            Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), Vector3d::UnitZ());
        const Ball ball{
            {collider.pose.place, Vector3d::Constant(radius), collider.pose.orientation * towards},
            lengthOf(collider.shape) / 2};
        const bool isDrawn = isDrawableShape(ball.shape) && isDrawable({ball.apart, 0, 0});
        return isDrawn ? std::optional(ball) : std::nullopt;
    }
};

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

std::vector<PlacedCollider> instrumentsOf(const RenderScene& scene) {
    std::vector<PlacedCollider> instruments = scene.instruments;
    if (scene.heldInstrument) instruments.push_back(*scene.heldInstrument);
    return instruments;
}

MarkerDrawer::MarkerDrawer(const GlFunctions& gl)
    : m_gl(gl), m_steel(gl, shaders::ballVertex(), shaders::steelFragment()),
      m_shell(gl, shaders::ballVertex(), shaders::shellFragment()),
      m_quad(gl, shaders::quadVertex(), shaders::quadFragment()), m_ballVertices(gl), m_ballIndices(gl),
      m_ball(gl), m_emptyArray(gl), m_curvePoints(gl), m_curveSegments(gl) {
    const std::vector<BallPoint> points = ballPoints();
    const std::vector<std::uint32_t> triangles = ballTriangles();
    m_ballIndexCount = static_cast<GLsizei>(triangles.size());
    m_ball.bind();
    m_ballVertices.upload(GL_ARRAY_BUFFER, points.data(), points.size() * sizeof(BallPoint), GL_STATIC_DRAW);
    m_ballIndices.upload(GL_ELEMENT_ARRAY_BUFFER, triangles.data(), triangles.size() * sizeof(std::uint32_t),
                         GL_STATIC_DRAW);
    m_ball.addFloats(0, 3, sizeof(BallPoint), 0);
    m_ball.addFloats(1, 1, sizeof(BallPoint), sizeof(Vector3f));
}

void MarkerDrawer::drawInstrument(const PlacedCollider& instrument, const Frame& frame) const {
    const std::optional<Ball> ball = Ball::of(instrument);
    if (!ball) return;
    m_steel.use();
    m_steel.set("baseColour", toFloat(steel));
    drawBall(m_steel, *ball, frame);
}

/// It acts inside the organ too: what the surface hides of it stays in sight.
void MarkerDrawer::drawHiddenInstrument(const PlacedCollider& instrument, const Frame& frame) const {
    const std::optional<Ball> ball = Ball::of(instrument);
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
    for (const PlacedCollider& instrument : instrumentsOf(scene))
        drawHiddenInstrument(instrument, frame);
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
    drawBall(m_shell, {ellipsoid.shape}, frame);
    m_gl.Disable(GL_CULL_FACE);
}

void MarkerDrawer::drawBall(const GlProgram& program, const Ball& ball, const Frame& frame) const {
    Eigen::Matrix4f model = Eigen::Matrix4f::Identity();
    model.topLeftCorner<3, 3>() =
        (ball.shape.orientation.toRotationMatrix() * ball.shape.radii.asDiagonal()).cast<float>();
    model.topRightCorner<3, 1>() = frame.local(ball.shape.centre);
    program.set("model", model);
    program.set("apart", Vector3f((ball.shape.orientation * Vector3d(0, ball.apart, 0)).cast<float>()));
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
        texture->upload(shrunk(*photo, largestDrawnPhoto), photoLevels);
    }
    return texture.get();
}

} // namespace esm
