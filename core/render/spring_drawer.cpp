#include "core/render/spring_drawer.h"

#include "core/render/colour_ramp.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

constexpr float liftShare = 0.004F, largestLift = 0.03F; // of the organ's size
constexpr float colouredWidth = 1.5F, quietWidth = 1.0F; // pixels
constexpr float markRadius = 3;                          // pixels
const Eigen::Vector4f dotPaint(0.91F, 0.91F, 0.93F, 1);

/// Over a surface its texture and shape stay to be seen.
std::array<std::uint8_t, 4> springPaint(const Colour& colour, bool overSurface) {
    return {colour[0], colour[1], colour[2], overSurface ? std::uint8_t{150} : std::uint8_t{255}};
}

/// How far a surface lies from the coarser one that carries it, m, as far as springs can be lifted out of it.
double coverOver(const RenderScene& scene) {
    if (!scene.network->binding || !scene.mesh) return 0;
    const std::vector<VertexBinding>& vertices = scene.network->binding->vertices;
    const std::vector<Eigen::Vector3d>& nodes = scene.network->restPositions;
    double farthest = 0;
    for (std::size_t i = 0; i < std::min(vertices.size(), scene.mesh->vertices.size()); ++i) {
        const auto& [a, b, c] = vertices[i].nodes;
        const Eigen::Vector3d& shares = vertices[i].shares;
        const Eigen::Vector3d below = shares[0] * nodes[a] + shares[1] * nodes[b] + shares[2] * nodes[c];
        farthest = std::max(farthest, (scene.mesh->vertices[i] - below).norm());
    }
    return farthest;
}

bool movesRigidly(const RenderScene& scene) {
    return scene.network->binding && scene.network->binding->surface.empty();
}

} // namespace

SpringDrawer::SpringDrawer(const GlFunctions& gl)
    : m_gl(gl), m_points(gl), m_marks(gl), m_quiet(gl), m_coloured(gl) {}

void SpringDrawer::draw(const RenderScene& scene, const std::vector<Eigen::Vector3d>& nodes,
                        const LineDrawer& lines, const Frame& frame) {
    if (!scene.network) return;
    const bool bare = !scene.mesh || scene.mesh->triangles.empty();
    if (!scene.showSprings && !bare) return;
    const bool overSurface = scene.showSurface && !bare;
    // The few springs inside a stiff organ are seen through it.
    const bool inside = overSurface && movesRigidly(scene);
    takeSprings(scene, overSurface && !inside);
    if (nodes != m_nodes) {
        m_points.upload(nodes, frame);
        m_nodes = nodes;
    }
    // Where a surface is hidden nothing else puts the far springs behind the near ones. A few bare springs
    // need no such order, and would cut into their nodes' dots.
    m_gl.DepthMask(overSurface || bare ? GL_FALSE : GL_TRUE);
    if (inside) m_gl.Disable(GL_DEPTH_TEST);
    const float lift = std::min(liftShare * frame.size + m_cover, largestLift * frame.size);
    const LineStyle style{1, overSurface && !inside ? lift : 0, true};
    lines.draw(m_points, m_quiet, style, frame);
    lines.draw(m_points, m_coloured, {1, style.lift, false}, frame);
    if (bare || inside) lines.drawDots(m_points, dotPaint, 4.0F, frame);
    drawMarks(scene.fixedNodes, bare || inside ? 2 * markRadius : markRadius, lines, frame);
    if (inside) m_gl.Enable(GL_DEPTH_TEST);
    m_gl.DepthMask(GL_TRUE);
}

void SpringDrawer::drawMarks(const std::vector<std::uint32_t>& marked, float radius, const LineDrawer& lines,
                             const Frame& frame) {
    if (marked.empty()) return;
    std::vector<Eigen::Vector3d> places;
    places.reserve(marked.size());
    for (const std::uint32_t node : marked)
        places.push_back(m_nodes[node]);
    m_marks.upload(places, frame);
    lines.drawDots(m_marks, dotPaint, radius, frame);
}

void SpringDrawer::takeSprings(const RenderScene& scene, bool overSurface) {
    const bool same = scene.network == m_network && scene.springValues == m_values &&
                      scene.springValueMinimum == m_minimum && scene.springValueMaximum == m_maximum &&
                      overSurface == m_overSurface;
    if (same) return;
    if (scene.network != m_network) m_cover = static_cast<float>(coverOver(scene));
    m_network = scene.network;
    m_values = scene.springValues;
    m_minimum = scene.springValueMinimum;
    m_maximum = scene.springValueMaximum;
    m_overSurface = overSurface;
    const auto& springs = m_network->springs;
    const bool valued = m_values && m_values->size() == springs.size();
    const double range = m_maximum > m_minimum ? m_maximum - m_minimum : 1;
    const std::array<std::uint8_t, 4> quiet = overSurface ? std::array<std::uint8_t, 4>{44, 40, 46, 105}
                                                          : std::array<std::uint8_t, 4>{152, 161, 171, 190};
    std::vector<Segment> quietSegments, coloured;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const Spring& spring = springs[i];
        if (valued && std::isfinite((*m_values)[i])) {
            const Colour colour = rampColour(((*m_values)[i] - m_minimum) / range);
            coloured.push_back(
                {spring.first, spring.second, springPaint(colour, overSurface), colouredWidth});
        } else {
            quietSegments.push_back({spring.first, spring.second, quiet, quietWidth});
        }
    }
    m_quiet.upload(quietSegments);
    m_coloured.upload(coloured);
}

} // namespace esm
