#include "core/render/renderer.h"

#include "core/render/drawn_shape.h"
#include "core/render/frame.h"
#include "core/render/marker_drawer.h"
#include "core/render/shaders.h"
#include "core/render/spring_drawer.h"
#include "core/render/surface_drawer.h"
#include "core/render/wireframe_drawer.h"

#include <array>
#include <cmath>
#include <utility>

namespace esm {
namespace {

Eigen::AlignedBox3d restBoxOf(const RenderScene& scene) {
    if (scene.mesh && !scene.mesh->vertices.empty()) return boundingBox(scene.mesh->vertices);
    return scene.network ? boundingBox(scene.network->restPositions) : Eigen::AlignedBox3d();
}

void extend(Eigen::AlignedBox3d& box, const Eigen::Vector3d& point) {
    if (isDrawable(point)) box.extend(point);
}

/// A box around all that is drawn beside the organ as well.
Eigen::AlignedBox3d wholeBox(const RenderScene& scene, const Eigen::AlignedBox3d& organ) {
    Eigen::AlignedBox3d box = organ;
    for (const DrawnEllipsoid& drawn : scene.ellipsoids)
        for (const double side : {-1.0, 1.0})
            extend(box, drawn.shape.centre.array() + side * (drawn.shape.radii.maxCoeff() + drawn.rim));
    for (const DrawnProjector& drawn : scene.projectors)
        for (const Eigen::Vector3d& corner : projectorBox(drawn, organ))
            extend(box, corner);
    for (const PlacedCollider& instrument : instrumentsOf(scene))
        for (const double side : {-1.0, 1.0}) {
            const ColliderAxis axis = axisOf(instrument);
            for (const double end : {-axis.half, axis.half})
                extend(box, axis.at(end).array() + side * radiusOf(instrument.shape));
        }
    return box;
}

/// In the camera's space.
Eigen::Vector4f seenCut(const CutPlane& cut, const Camera& camera) {
    const Eigen::Vector3d hidden = cameraAxes(camera).transpose() * cut.normal;
    const double left = cut.offset - cut.normal.dot(camera.eye);
    return Eigen::Vector4d(-hidden.x(), -hidden.y(), -hidden.z(), left).cast<float>();
}

/// As an endoscope sets its exposure: the picture is as bright in the mean as what lies at this distance. A
/// vertex counts by the room that it takes in the picture, which falls with the square of the distance as
/// light does: near walls fill it, and hidden ones are mostly far. A few thousand vertices within 45° of the
/// line of sight tell it.
double exposedDistance(const Camera& camera, const std::vector<Eigen::Vector3d>& vertices) {
    constexpr double widestSeen = 0.7; // cosine of the angle to the line of sight
    constexpr std::size_t mostAsked = 4000;
    const Eigen::Vector3d sight = (camera.target - camera.eye).normalized();
    double room = 0, brightness = 0;
    for (std::size_t i = 0; i < vertices.size(); i += 1 + vertices.size() / mostAsked) {
        const Eigen::Vector3d way = vertices[i] - camera.eye;
        if (!(way.dot(sight) > widestSeen * way.norm())) continue;
        const double share = 1 / way.squaredNorm();
        room += share;
        brightness += share * share;
    }
    return brightness > 0 ? std::sqrt(room / brightness) : (camera.target - camera.eye).norm();
}

bool hasProjectedPhoto(const RenderScene& scene) {
    return scene.projectedPhoto && scene.projectedPhoto->photo && !scene.projectedPhoto->photo->empty() &&
           scene.projectedPhoto->opacity > 0 && scene.showSurface && scene.mesh &&
           !scene.mesh->triangles.empty();
}

} // namespace

struct Renderer::Implementation {
    /// The organ as it was drawn last: while it is only turned, its vertices are not carried anew.
    struct DrawnOrgan {
        std::shared_ptr<const TriangleMesh> mesh;
        std::shared_ptr<const SpringNetwork> network;
        std::vector<Eigen::Vector3d> nodes, vertices; ///< m
        Eigen::AlignedBox3d box, restBox;

        void take(const RenderScene& scene) {
            std::vector<Eigen::Vector3d> now = drawnNodes(scene);
            const bool isSameOrgan = scene.mesh == mesh && scene.network == network;
            if (isSameOrgan && now == nodes) return;
            mesh = scene.mesh;
            network = scene.network;
            nodes = std::move(now);
            vertices = drawnVertices(scene, nodes);
            box = boundingBox(vertices).merged(boundingBox(nodes));
            if (!isSameOrgan) restBox = restBoxOf(scene);
        }
    };

    explicit Implementation(const Resolver& resolver)
        : gl(resolver), background(gl, shaders::backgroundVertex(), shaders::backgroundFragment()),
          emptyArray(gl), surface(gl), projection(gl), wireframe(gl), springs(gl), lines(gl), markers(gl) {}

    void drawBackground(const RenderScene& scene, const Frame& frame) const;
    Frame frameFor(const RenderScene& scene, const Camera& camera, const PictureSize& size) const;
    void prepare(const PictureSize& size) const;
    void tidy() const;

    DrawnOrgan organ;
    GlFunctions gl;
    GlProgram background;
    GlVertexArray emptyArray;
    SurfaceDrawer surface;
    PhotoProjection projection;
    WireframeDrawer wireframe;
    SpringDrawer springs;
    LineDrawer lines;
    MarkerDrawer markers;
};

Renderer::Renderer(const Resolver& resolver) : m_implementation(std::make_unique<Implementation>(resolver)) {}

Renderer::~Renderer() = default;

/// The order is that of what hides what. Opaque things first, in any order, as depth decides; then what is
/// seen through, which tests depth and does not write it. The depth map of a projected photo is drawn before
/// all, as it needs a target of its own.
void Renderer::draw(const RenderScene& scene, const Camera& camera, const PictureSize& size) {
    if (size.width <= 0 || size.height <= 0) return;
    Implementation& parts = *m_implementation;
    parts.organ.take(scene);
    const Renderer::Implementation::DrawnOrgan& organ = parts.organ;
    const Frame frame = parts.frameFor(scene, camera, size);
    const bool hasPhoto = hasProjectedPhoto(scene);
    if (hasPhoto) parts.projection.take(*scene.projectedPhoto, scene.mesh, frame);
    parts.prepare(size);
    parts.drawBackground(scene, frame);
    parts.gl.Enable(GL_DEPTH_TEST);
    if (scene.cut) parts.gl.Enable(GL_CLIP_DISTANCE0);
    if (scene.showSurface)
        parts.surface.draw(scene, organ.vertices, frame, hasPhoto ? &parts.projection : nullptr);
    parts.gl.Disable(GL_CLIP_DISTANCE0);
    for (const PlacedCollider& instrument : instrumentsOf(scene))
        parts.markers.drawInstrument(instrument, frame);
    parts.gl.Enable(GL_BLEND);
    if (scene.cut) parts.gl.Enable(GL_CLIP_DISTANCE0);
    parts.wireframe.draw(scene, organ.vertices, parts.lines, frame);
    parts.springs.draw(scene, organ.nodes, parts.lines, frame);
    parts.gl.Disable(GL_CLIP_DISTANCE0);
    parts.gl.DepthMask(GL_FALSE);
    parts.markers.drawTransparent(scene, organ.box, parts.lines, frame);
    parts.tidy();
}

/// The origin is the middle of the organ at rest, taken out in double precision before anything becomes
/// float. It stays where it is while tissue moves, so that what was uploaded stays right.
Frame Renderer::Implementation::frameFor(const RenderScene& scene, const Camera& camera,
                                         const PictureSize& size) const {
    const Eigen::AlignedBox3d& rest = organ.restBox;
    Frame frame;
    frame.origin = rest.isEmpty() ? camera.target : Eigen::Vector3d(rest.center());
    Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
    shift.topRightCorner<3, 1>() = frame.origin;
    frame.view = (viewMatrix(camera) * shift).cast<float>();
    if (scene.cut) frame.cut = seenCut(*scene.cut, camera);
    const double aspect = double(size.width) / size.height;
    frame.projection = projectionMatrix(camera, aspect, wholeBox(scene, organ.box)).cast<float>();
    frame.pixels << float(size.width), float(size.height);
    frame.pixelRatio = static_cast<float>(size.pixelRatio);
    frame.size = rest.isEmpty() ? 1.0F : static_cast<float>(rest.diagonal().norm());
    frame.eye = viewpoint(camera, frame.size);
    frame.exposedDistance = static_cast<float>(exposedDistance(camera, organ.vertices));
    return frame;
}

/// The context may be shared with Qt's painter, which leaves states as it likes: every one that matters here
/// is set, none expected.
void Renderer::Implementation::prepare(const PictureSize& size) const {
    gl.Viewport(-size.left, -size.bottom, size.width, size.height);
    constexpr std::array<GLenum, 6> unwantedStates{GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE,
                                                   GL_BLEND,        GL_DEPTH_TEST,   GL_CLIP_DISTANCE0};
    for (const GLenum unwanted : unwantedStates)
        gl.Disable(unwanted);
    gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LEQUAL);
    gl.CullFace(GL_BACK);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Renderer::Implementation::drawBackground(const RenderScene& scene, const Frame& frame) const {
    background.use();
    background.set("top", toFloat(scene.backgroundTop));
    background.set("bottom", toFloat(scene.backgroundBottom));
    background.set("pixels", frame.pixels);
    emptyArray.bind();
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

/// Leaves the context as another painter expects to find it.
void Renderer::Implementation::tidy() const {
    for (const GLenum used : std::array<GLenum, 3>{GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE})
        gl.Disable(used);
    gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS);
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    for (const GLenum target : std::array<GLenum, 2>{GL_ARRAY_BUFFER, GL_TEXTURE_BUFFER})
        gl.BindBuffer(target, 0);
    constexpr GLenum units = 8; // the photo's and the finish's among them
    for (GLenum unit = GL_TEXTURE0 + units; unit-- > GL_TEXTURE0;) {
        gl.ActiveTexture(unit);
        gl.BindTexture(GL_TEXTURE_2D, 0);
        gl.BindTexture(GL_TEXTURE_BUFFER, 0);
    }
}

} // namespace esm
