#include "core/dynamics/statics/sphere_contacts.h"

#include "core/geometry/nearest_weights.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Times what resists the motion of a triangle. Each update of the pushes then leaves about a tenth of what
/// was missing. Harder ones leave less, but the search for balance, which does not know yet what will touch,
/// takes more steps: with 10, 100 and 1000 as many as 42, 52 and 85 for a press of four depths into a block.
constexpr double relativeHardness = 10;
constexpr double looked = 1.2; ///< radii, so far triangles are looked at that may come to touch
/// Share of a point that its movable nodes must carry, as in a simulation.
constexpr double leastShare = 0.2;

using TriangleBlocks = std::array<std::array<Matrix3d, 3>, 3>;

/// How the distance d of a triangle's nearest point from the centre is curved over its corners, 1/m. With r
/// from the centre to that point and w its weights, d²/2 changes by w·r with the corners. As they move, the
/// nearest point slides along the triangle's free directions J, which are none at a corner, one on an edge
/// and two within: it goes where r stays upright on them. What that takes off the curvature is a Schur
/// complement.
TriangleBlocks curvatureOfDistance(const std::array<Vector3d, 3>& corners, const Vector3d& weights,
                                   const Vector3d& outward, double distance) {
    std::array<int, 3> touched{};
    int count = 0;
    for (int i = 0; i < 3; ++i)
        if (weights[i] > 0) touched.at(static_cast<std::size_t>(count++)) = i;
    const int free = count - 1;
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2> sides(3, free), changes(3, free);
    changes.setZero();
    for (int j = 0; j < free; ++j) {
        const int base = touched[0], other = touched.at(static_cast<std::size_t>(j) + 1);
        sides.col(j) =
            corners.at(static_cast<std::size_t>(other)) - corners.at(static_cast<std::size_t>(base));
        changes(other, j) = 1;
        changes(base, j) = -1;
    }
    // Along a side without length, or two of one direction, no point slides, rather than infinitely far.
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2> slides(free, free);
    if (free > 0) slides = (sides.transpose() * sides).completeOrthogonalDecomposition().pseudoInverse();
    const Vector3d way = distance * outward;
    TriangleBlocks blocks;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
            Matrix3d block = weights[a] * weights[b] * (Matrix3d::Identity() - outward * outward.transpose());
            if (free > 0)
                block -= (way * changes.row(a) + weights[a] * sides) * slides *
                         (way * changes.row(b) + weights[b] * sides).transpose();
            blocks.at(static_cast<std::size_t>(a)).at(static_cast<std::size_t>(b)) = block / distance;
        }
    return blocks;
}

} // namespace

SphereContacts::SphereContacts(std::vector<Triangle> triangles, std::vector<char> immovable, double radius)
    : m_triangles(std::move(triangles)), m_immovable(std::move(immovable)),
      m_stiffness(m_immovable.size(), 0), m_radius(radius) {}

void SphereContacts::setStiffness(std::vector<double> stiffness) {
    m_stiffness = std::move(stiffness);
    for (Near& near : m_near)
        near.hardness = hardnessOf(cornersOf(near));
}

bool SphereContacts::givesWay(const Triangle& triangle, const Vector3d& weights) const {
    double share = 0;
    for (int i = 0; i < 3; ++i)
        if (!m_immovable[triangle[static_cast<std::size_t>(i)]]) share += weights[i];
    return share >= leastShare;
}

double SphereContacts::hardnessOf(const Triangle& triangle) const {
    double stiffness = 0;
    for (const std::uint32_t node : triangle)
        stiffness = std::max(stiffness, m_stiffness[node]);
    return relativeHardness * stiffness;
}

SphereContacts::Standing SphereContacts::standing(const Near& near, const Vector3d& centre,
                                                  const Vectors& positions) const {
    const auto& [a, b, c] = cornersOf(near);
    const Vector3d weights = nearestWeights(centre, positions[a], positions[b], positions[c]);
    const Vector3d way =
        weights[0] * positions[a] + weights[1] * positions[b] + weights[2] * positions[c] - centre;
    const double distance = way.norm();
    if (!(distance > 0) || !givesWay(cornersOf(near), weights))
        return {weights, Vector3d::Zero(), distance, 0};
    return {weights, way / distance, distance,
            std::max(0.0, near.push + near.hardness * (m_radius - distance))};
}

bool SphereContacts::find(const Vector3d& centre, const Vectors& positions, double tolerance) {
    const double reach = looked * m_radius;
    std::vector<Near> before = std::exchange(m_near, {});
    auto known = before.begin();
    bool isNew = false;
    for (std::uint32_t i = 0; i < m_triangles.size(); ++i) {
        while (known != before.end() && known->triangle < i)
            ++known;
        const bool isKnown = known != before.end() && known->triangle == i;
        const auto& [a, b, c] = m_triangles[i];
        const Eigen::AlignedBox3d box =
            Eigen::AlignedBox3d(positions[a]).extend(positions[b]).extend(positions[c]);
        if (box.squaredExteriorDistance(centre) > reach * reach) continue;
        m_near.push_back(isKnown ? *known : Near{i, hardnessOf(m_triangles[i])});
        const Standing now = standing(m_near.back(), centre, positions);
        const bool isInside = now.fromCentre < m_radius - tolerance;
        if (isInside && !givesWay(m_triangles[i], now.weights)) m_meetsImmovable = true;
        isNew = isNew || (isInside && !isKnown && now.push > 0);
    }
    return isNew;
}

double SphereContacts::energy(const Vector3d& centre, const Vectors& positions) const {
    double sum = 0;
    for (const Near& near : m_near) {
        const double push = standing(near, centre, positions).push;
        if (push <= 0 && near.push <= 0) continue; // as of what nothing holds, which has no hardness
        sum += 0.5 * (push * push - near.push * near.push) / near.hardness;
    }
    return sum;
}

void SphereContacts::addForces(const Vector3d& centre, const Vectors& positions, Vectors& forces) const {
    for (const Near& near : m_near) {
        const Standing now = standing(near, centre, positions);
        if (now.push <= 0) continue;
        for (std::size_t i = 0; i < 3; ++i)
            if (const std::uint32_t node = cornersOf(near)[i]; !m_immovable[node])
                forces[node] += now.weights[static_cast<Eigen::Index>(i)] * now.push * now.outward;
    }
}

void SphereContacts::addStiffness(const Vector3d& centre, const Vectors& positions,
                                  BlockEntries& entries) const {
    for (const Near& near : m_near) {
        const Standing now = standing(near, centre, positions);
        if (now.push <= 0) continue;
        const Triangle& corners = cornersOf(near);
        const TriangleBlocks bent =
            curvatureOfDistance({positions[corners[0]], positions[corners[1]], positions[corners[2]]},
                                now.weights, now.outward, now.fromCentre);
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b) {
                const double both =
                    now.weights[static_cast<Eigen::Index>(a)] * now.weights[static_cast<Eigen::Index>(b)];
                entries.add(corners[a], corners[b],
                            both * near.hardness * now.outward * now.outward.transpose() -
                                now.push * bent[a][b]);
            }
    }
}

PushAlong SphereContacts::along(const Vector3d& direction, const Vector3d& centre,
                                const Vectors& positions) const {
    PushAlong result;
    result.coupling.assign(positions.size(), Vector3d::Zero());
    for (const Near& near : m_near) {
        const Standing now = standing(near, centre, positions);
        if (now.push <= 0) continue;
        const double slope = now.outward.dot(direction);
        result.force += now.push * slope;
        result.stiffness += near.hardness * slope * slope;
        for (std::size_t i = 0; i < 3; ++i)
            if (const std::uint32_t node = cornersOf(near)[i]; !m_immovable[node])
                result.coupling[node] -=
                    now.weights[static_cast<Eigen::Index>(i)] * near.hardness * slope * now.outward;
    }
    return result;
}

Vector3d SphereContacts::force(const Vector3d& centre, const Vectors& positions) const {
    Vector3d sum = Vector3d::Zero();
    for (const Near& near : m_near) {
        const Standing now = standing(near, centre, positions);
        sum += now.push * now.outward;
    }
    return sum;
}

double SphereContacts::pushes(const Vector3d& centre, const Vectors& positions) const {
    double sum = 0;
    for (const Near& near : m_near)
        sum += standing(near, centre, positions).push;
    return sum;
}

// Triangles that meet in a touched edge or corner may share its push in any way, and go on doing so for long.
// What they do together is settled much sooner, and is all that tissue and sphere feel.
double SphereContacts::update(const Vector3d& centre, const Vectors& positions) {
    Vector3d change = Vector3d::Zero();
    for (Near& near : m_near) {
        const Standing now = standing(near, centre, positions);
        change += (now.push - near.push) * now.outward;
        near.push = now.push;
    }
    return change.norm();
}

} // namespace esm
