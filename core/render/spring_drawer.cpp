#include "core/render/spring_drawer.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

constexpr float liftShare = 0.004F, largestLift = 0.03F;                        // of the organ's size
constexpr float colouredWidth = 1.5F, quietWidth = 1.0F;                        // pixels
constexpr float markedWidth = 1.7F, markedValuedWidth = 2.6F, markedRadius = 2; // pixels
constexpr double markedAlpha = 225;
constexpr float fixedRadius = 4, fixedEdge = 1.3F; // pixels
const Eigen::Vector4f dotPaint(0.91F, 0.91F, 0.93F, 1);

constexpr float nodeRadius = 2.2F, nodeEdge = 0.9F, bareNodeRadius = 4; // pixels

/// Over a surface its texture and shape stay to be seen.
Paint paintOver(const Paint& paint, bool overSurface) {
    return {paint[0], paint[1], paint[2], overSurface ? std::uint8_t{150} : std::uint8_t{255}};
}

bool isPainted(const std::vector<Paint>* paint, std::size_t spring) {
    return paint && (*paint)[spring][3] > 0;
}

/// How far a surface lies from the coarser one that carries it, m, as far as springs can be lifted out of it.
double coverOver(const RenderScene& scene) {
    if (!scene.network->binding || !scene.mesh) return 0;
    const BindingRows& vertices = scene.network->binding->vertices;
    const std::vector<Eigen::Vector3d>& nodes = scene.network->restPositions;
    double farthest = 0;
    for (std::size_t i = 0; i < std::min(vertices.size(), scene.mesh->vertices.size()); ++i) {
        const auto& [carrying, shares] = vertices[i];
        Eigen::Vector3d below = Eigen::Vector3d::Zero();
        for (std::size_t place = 0; place < carrying.size(); ++place)
            below += shares[place] * nodes[carrying[place]];
        farthest = std::max(farthest, (scene.mesh->vertices[i] - below).norm());
    }
    return farthest;
}

bool movesRigidly(const RenderScene& scene) {
    return scene.network->binding && isOnOneLine(*scene.network->binding);
}

} // namespace

SpringDrawer::SpringDrawer(const GlFunctions& gl)
    : m_gl(gl), m_points(gl), m_fixedPoints(gl), m_markedPoints(gl), m_quiet(gl), m_coloured(gl),
      m_markedSprings(gl) {}

void SpringDrawer::draw(const RenderScene& scene, const std::vector<Eigen::Vector3d>& nodes,
                        const LineDrawer& lines, const Frame& frame) {
    if (!scene.network) return;
    const bool bare = !scene.mesh || scene.mesh->triangles.empty();
    const bool showsSprings = scene.showSprings || bare;
    if (!showsSprings && !scene.showNodes && !scene.marked && scene.fixedNodes.empty()) return;
    takeNetwork(scene);
    const Manner manner = mannerOf(scene, frame);
    if (nodes != m_nodes) {
        m_points.upload(nodes, frame);
        m_nodes = nodes;
        ++m_pose;
    }
    // Where a surface is hidden nothing else puts the far springs behind the near ones. A few bare springs
    // need no such order, and would cut into their nodes' dots.
    m_gl.DepthMask(manner.overSurface || bare ? GL_FALSE : GL_TRUE);
    if (manner.inside) m_gl.Disable(GL_DEPTH_TEST);
    if (showsSprings) drawSprings(scene, manner, lines, frame);
    drawNodes(scene, manner, lines, frame);
    if (scene.marked) drawMarked(scene, manner, lines, frame);
    drawFixed(scene.fixedNodes, manner, lines, frame);
    if (manner.inside) m_gl.Enable(GL_DEPTH_TEST);
    m_gl.DepthMask(GL_TRUE);
}

void SpringDrawer::takeNetwork(const RenderScene& scene) {
    if (scene.network == m_network) return;
    m_network = scene.network;
    m_cover = static_cast<float>(coverOver(scene));
}

SpringDrawer::SpringPaint SpringDrawer::paintOf(const RenderScene& scene) const {
    const bool fits = scene.springPaint && scene.springPaint->size() == m_network->springs.size();
    return fits ? scene.springPaint : nullptr;
}

/// Springs over a surface lie in it, or beneath a finer surface that is drawn: they are lifted towards the
/// eye by as much as that surface lies over its nodes, but never so far that springs of the far side come
/// through.
SpringDrawer::Manner SpringDrawer::mannerOf(const RenderScene& scene, const Frame& frame) const {
    const bool bare = !scene.mesh || scene.mesh->triangles.empty();
    const bool overSurface = scene.showSurface && !bare;
    // The few springs inside a stiff organ are seen through it.
    const bool inside = overSurface && movesRigidly(scene);
    const float lift = std::min(liftShare * frame.size + m_cover, largestLift * frame.size);
    return {bare, overSurface, inside, overSurface && !inside ? lift : 0};
}

void SpringDrawer::drawSprings(const RenderScene& scene, const Manner& manner, const LineDrawer& lines,
                               const Frame& frame) {
    takeSprings(scene, manner.overSurface && !manner.inside);
    lines.draw(m_points, m_quiet, {1, manner.lift, true}, frame);
    lines.draw(m_points, m_coloured, {1, manner.lift, false}, frame);
}

/// Where there is nothing else to see, or little, they are large.
void SpringDrawer::drawNodes(const RenderScene& scene, const Manner& manner, const LineDrawer& lines,
                             const Frame& frame) const {
    if (manner.bare || (manner.inside && scene.showSprings))
        lines.drawDots(m_points, {dotPaint, bareNodeRadius}, frame);
    else if (scene.showNodes)
        lines.drawDots(m_points, {dotPaint, nodeRadius, nodeEdge, manner.lift}, frame);
}

void SpringDrawer::drawMarked(const RenderScene& scene, const Manner& manner, const LineDrawer& lines,
                              const Frame& frame) {
    if (scene.marked->weights->size() != m_nodes.size()) return;
    takeMarked(scene);
    lines.draw(m_points, m_markedSprings, {1, manner.lift, false}, frame);
    takeMarkedDots(scene.marked->weights, frame);
    const Eigen::Vector3f rgb = toFloat(scene.marked->colour);
    const float radius = manner.bare || manner.inside ? 5 : markedRadius;
    lines.drawDots(m_markedPoints, {{rgb.x(), rgb.y(), rgb.z(), 1}, radius, 0, manner.lift}, frame);
}

void SpringDrawer::takeMarkedDots(const std::shared_ptr<const std::vector<double>>& weights,
                                  const Frame& frame) {
    if (m_markedDots.choice == weights && m_markedDots.pose == m_pose) return;
    m_markedDots = {weights, m_pose};
    std::vector<Eigen::Vector3d> places;
    std::vector<float> strengths;
    for (std::size_t node = 0; node < weights->size(); ++node) {
        if (!((*weights)[node] > 0)) continue;
        places.push_back(m_nodes[node]);
        strengths.push_back(static_cast<float>((*weights)[node]));
    }
    m_markedPoints.upload(places, frame, strengths);
}

/// Springs whose both ends are marked, as strongly as the less marked of them.
void SpringDrawer::takeMarked(const RenderScene& scene) {
    const MarkedNodes& marked = *scene.marked;
    const SpringPaint paint = scene.showSprings ? paintOf(scene) : nullptr;
    if (m_markedNetwork == m_network && m_weights == marked.weights && m_markedPaint == paint &&
        m_markedColour == marked.colour)
        return;
    m_markedNetwork = m_network;
    m_weights = marked.weights;
    m_markedPaint = paint;
    m_markedColour = marked.colour;
    const auto& springs = m_network->springs;
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const auto [first, second, length] = springs[i];
        const double weight = std::min((*m_weights)[first], (*m_weights)[second]);
        if (!(weight > 0)) continue;
        const bool hasPaint = isPainted(paint.get(), i);
        const auto& [red, green, blue, cover] =
            hasPaint ? (*paint)[i] : Paint{marked.colour[0], marked.colour[1], marked.colour[2], 255};
        const auto alpha = static_cast<std::uint8_t>(std::lround(markedAlpha * weight));
        segments.push_back(
            {first, second, {red, green, blue, alpha}, hasPaint ? markedValuedWidth : markedWidth});
    }
    m_markedSprings.upload(segments);
}

void SpringDrawer::drawFixed(const std::vector<std::uint32_t>& fixed, const Manner& manner,
                             const LineDrawer& lines, const Frame& frame) {
    if (fixed.empty()) return;
    if (m_fixedDots.choice != fixed || m_fixedDots.pose != m_pose) {
        m_fixedDots = {fixed, m_pose};
        std::vector<Eigen::Vector3d> places;
        places.reserve(fixed.size());
        for (const std::uint32_t node : fixed)
            places.push_back(m_nodes[node]);
        m_fixedPoints.upload(places, frame);
    }
    const float radius = manner.bare || manner.inside ? 2 * fixedRadius : fixedRadius;
    lines.drawDots(m_fixedPoints, {dotPaint, radius, fixedEdge, manner.lift}, frame);
}

/// Which springs there are and how they are coloured is uploaded only when it changes: in a running
/// simulation positions alone do, which are points that all segments share.
void SpringDrawer::takeSprings(const RenderScene& scene, bool overSurface) {
    const SpringPaint paint = paintOf(scene);
    if (m_springsNetwork == m_network && m_paint == paint && overSurface == m_overSurface) return;
    m_springsNetwork = m_network;
    m_paint = paint;
    m_overSurface = overSurface;
    const auto& springs = m_network->springs;
    const Paint quiet = overSurface ? Paint{44, 40, 46, 105} : Paint{152, 161, 171, 190};
    std::vector<Segment> quietSegments, coloured;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const Spring& spring = springs[i];
        if (isPainted(paint.get(), i))
            coloured.push_back(
                {spring.first, spring.second, paintOver((*paint)[i], overSurface), colouredWidth});
        else
            quietSegments.push_back({spring.first, spring.second, quiet, quietWidth});
    }
    m_quiet.upload(quietSegments);
    m_coloured.upload(coloured);
}

} // namespace esm
