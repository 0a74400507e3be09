#include "core/render/spring_drawer.h"

#include "core/render/colour_ramp.h"

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

/// Over a surface its texture and shape stay to be seen.
std::array<std::uint8_t, 4> springPaint(const Colour& colour, bool overSurface) {
    return {colour[0], colour[1], colour[2], overSurface ? std::uint8_t{150} : std::uint8_t{255}};
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
    return scene.network->binding && scene.network->binding->surface.empty();
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
    if (!showsSprings && !scene.marked && scene.fixedNodes.empty()) return;
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

std::optional<Colour> SpringDrawer::SpringColours::of(std::size_t spring) const {
    if (!values || !std::isfinite((*values)[spring])) return std::nullopt;
    const double range = maximum > minimum ? maximum - minimum : 1;
    return rampColour(((*values)[spring] - minimum) / range);
}

SpringDrawer::SpringColours SpringDrawer::coloursOf(const RenderScene& scene) const {
    if (!scene.springValues || scene.springValues->size() != m_network->springs.size()) return {};
    return {scene.springValues, scene.springValueMinimum, scene.springValueMaximum};
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
    if (manner.bare || manner.inside) lines.drawDots(m_points, {dotPaint, 4}, frame);
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
    const SpringColours colours = scene.showSprings ? coloursOf(scene) : SpringColours{};
    if (m_markedNetwork == m_network && m_weights == marked.weights && m_markedColours == colours &&
        m_markedColour == marked.colour)
        return;
    m_markedNetwork = m_network;
    m_weights = marked.weights;
    m_markedColours = colours;
    m_markedColour = marked.colour;
    const auto& springs = m_network->springs;
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const auto [first, second, length] = springs[i];
        const double weight = std::min((*m_weights)[first], (*m_weights)[second]);
        if (!(weight > 0)) continue;
        const std::optional<Colour> ofValue = colours.of(i);
        const Colour colour = ofValue.value_or(marked.colour);
        const auto alpha = static_cast<std::uint8_t>(std::lround(markedAlpha * weight));
        segments.push_back({first,
                            second,
                            {colour[0], colour[1], colour[2], alpha},
                            ofValue ? markedValuedWidth : markedWidth});
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
    const SpringColours colours = coloursOf(scene);
    if (m_springsNetwork == m_network && m_colours == colours && overSurface == m_overSurface) return;
    m_springsNetwork = m_network;
    m_colours = colours;
    m_overSurface = overSurface;
    const auto& springs = m_network->springs;
    const std::array<std::uint8_t, 4> quiet = overSurface ? std::array<std::uint8_t, 4>{44, 40, 46, 105}
                                                          : std::array<std::uint8_t, 4>{152, 161, 171, 190};
    std::vector<Segment> quietSegments, coloured;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const Spring& spring = springs[i];
        if (const std::optional<Colour> colour = colours.of(i)) {
            coloured.push_back(
                {spring.first, spring.second, springPaint(*colour, overSurface), colouredWidth});
        } else {
            quietSegments.push_back({spring.first, spring.second, quiet, quietWidth});
        }
    }
    m_quiet.upload(quietSegments);
    m_coloured.upload(coloured);
}

} // namespace esm
