#pragma once

#include "core/render/renderer.h"

#include <vector>

namespace esm {

/// False for points that no picture can show: not finite or more than 1000 km away.
bool isDrawable(const Eigen::Vector3d& point);

/// The nodes' positions as drawn, one per node of the network or, without a network, per vertex. The rest
/// position stands in where the scene's positions are of another count (a frame of an older model) or not
/// drawable.
std::vector<Eigen::Vector3d> drawnNodes(const RenderScene& scene);

/// The surface's vertices for `drawnNodes`.
std::vector<Eigen::Vector3d> drawnVertices(const RenderScene& scene,
                                           const std::vector<Eigen::Vector3d>& nodes);

/// The paint of the nodes on the surface's vertices, mixed where several nodes carry one. Empty where nothing
/// is painted, or another count of nodes.
std::vector<Paint> vertexPaint(const RenderScene& scene, std::size_t vertexCount);

/// Whether every triangle that faces away is hidden by others, seen from outside.
bool isSolid(const TriangleMesh& mesh);

/// How far before a projector its photo is shown: none for a parallel one; before a perspective one between
/// the eye and the organ, near the eye where that stands beside or inside the organ.
double shownDepth(const Projector& projector, const Eigen::AlignedBox3d& organ);

/// The eight corners of a projector's box or frustum: the shown photo (bottom left, bottom right, top right,
/// top left), then the same at the far end, just behind everything that `shown` holds.
std::array<Eigen::Vector3d, 8> projectorBox(const DrawnProjector& drawn, const Eigen::AlignedBox3d& shown);

/// The closed curve along which an ellipsoid's outline is seen from `eye`; empty from inside it.
std::vector<Eigen::Vector3d> silhouette(const Ellipsoid& ellipsoid, const Eigen::Vector3d& eye);
/// The same of all that is at most `rim` (m) away from the ellipsoid.
std::vector<Eigen::Vector3d> rimSilhouette(const Ellipsoid& ellipsoid, double rim,
                                           const Eigen::Vector3d& eye);
/// The closed curve around an ellipsoid in the plane at a right angle to its own axis 0, 1 or 2.
std::vector<Eigen::Vector3d> greatCircle(const Ellipsoid& ellipsoid, int axis);

} // namespace esm
