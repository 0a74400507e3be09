#pragma once

#include "core/dynamics/contact/contact.h"

#include <array>

namespace esm {

/// A point of a triangle by its corners' weights, and the part of an axis that it is nearest to.
struct TrianglePoint {
    Eigen::Vector3d weights;
    AxisPart part;
};

/// Those points of a triangle, corners aside, that can be nearest to an axis in some direction.
class TrianglePoints {
public:
    using Corners = std::array<Eigen::Vector3d, 3>;
    TrianglePoints(const ColliderAxis& axis, const Corners& corners);

    const TrianglePoint* begin() const { return m_points.data(); }
    const TrianglePoint* end() const { return m_points.data() + m_count; }

private:
    void addEnds(const ColliderAxis& axis, const Corners& corners);
    void addEdges(const ColliderAxis& axis, const Corners& corners);
    void addPierced(const ColliderAxis& axis, const Corners& corners);
    void add(const Eigen::Vector3d& weights, AxisPart part) { m_points.at(m_count++) = {weights, part}; }

    std::array<TrianglePoint, 6> m_points;
    std::size_t m_count = 0;
};

/// Weights of the triangle's point that is nearest to the axis' whole line.
Eigen::Vector3d nearestToLine(const ColliderAxis& axis, const TrianglePoints::Corners& corners);

} // namespace esm
