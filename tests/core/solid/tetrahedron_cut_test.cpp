#include "core/solid/tetrahedron_cut.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace esm {
namespace {

using Eigen::Vector3d;

/// Where a corner of a piece is: cuts lie half-way.
Vector3d placeOf(const Edge& corner, const std::vector<Vector3d>& points) {
    return (points[corner.first] + points[corner.second]) / 2;
}

double volumeOfPiece(const TetrahedronPiece& piece, const std::vector<Vector3d>& points) {
    const Vector3d origin = placeOf(piece.corners[0], points);
    return std::abs((placeOf(piece.corners[1], points) - origin)
                        .cross(placeOf(piece.corners[2], points) - origin)
                        .dot(placeOf(piece.corners[3], points) - origin)) /
           6;
}

const std::vector<Vector3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

std::array<Side, 4> sidesOf(int pattern) {
    std::array<Side, 4> sides;
    for (Side& side : sides) {
        side = std::array{Side::Outside, Side::On, Side::Inside}[static_cast<std::size_t>(pattern % 3)];
        pattern /= 3;
    }
    return sides;
}

/// What a linear function that is 1 inside, −1 outside and 0 on the surface leaves of a tetrahedron, as a
/// share of it: half-way cuts. By sums over many points.
double sampledShare(const std::array<Side, 4>& sides) {
    constexpr int steps = 60;
    int within = 0, all = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; i + j < steps; ++j)
            for (int k = 0; i + j + k < steps; ++k) {
                const double a = (i + 0.25) / steps, b = (j + 0.25) / steps, c = (k + 0.25) / steps;
                const double weights[4] = {1 - a - b - c, a, b, c};
                double value = 0;
                for (std::size_t corner = 0; corner < 4; ++corner)
                    value += weights[corner] * (static_cast<int>(sides[corner]) - 1);
                ++all;
                within += value > 0;
            }
    return static_cast<double>(within) / all;
}

TEST(TetrahedronCut, LeavesThePartWithin) {
    for (int pattern = 0; pattern < 81; ++pattern) {
        const std::array<Side, 4> sides = sidesOf(pattern);
        double volume = 0;
        for (const TetrahedronPiece& piece : piecesWithin({0, 1, 2, 3}, sides)) {
            EXPECT_GT(volumeOfPiece(piece, corners), 1e-3);
            volume += volumeOfPiece(piece, corners);
        }
        EXPECT_NEAR(6 * volume, sampledShare(sides), 0.03) << "pattern " << pattern;
    }
}

TEST(TetrahedronCut, FitsFaceToFaceWithItsNeighbour) {
    // Two tetrahedra share the face 1, 2, 3. What pieces have in that face must be the same from both sides.
    const auto facesWithin = [](const std::vector<TetrahedronPiece>& pieces) {
        std::set<std::set<Edge>> faces;
        for (const TetrahedronPiece& piece : pieces)
            for (std::size_t opposite = 0; opposite < 4; ++opposite) {
                std::set<Edge> face;
                for (std::size_t i = 0; i < 4; ++i)
                    if (i != opposite) face.insert(piece.corners[i]);
                const bool isShared = std::all_of(face.begin(), face.end(), [](const Edge& corner) {
                    return corner.first >= 1 && corner.second <= 3;
                });
                if (isShared) faces.insert(face);
            }
        return faces;
    };
    for (int pattern = 0; pattern < 81; ++pattern)
        for (int apex = 0; apex < 3; ++apex) {
            const std::array<Side, 4> sides = sidesOf(pattern);
            const auto here = facesWithin(piecesWithin({0, 1, 2, 3}, sides));
            std::array<Side, 4> others = sides;
            others[0] = sidesOf(apex)[0];
            const auto there = facesWithin(piecesWithin({4, 1, 2, 3}, others));
            // A face all on the surface is kept by the side that lies within.
            const bool isOnSurface =
                std::all_of(sides.begin() + 1, sides.end(), [](Side side) { return side == Side::On; });
            if (!isOnSurface) {
                EXPECT_EQ(here, there) << "pattern " << pattern << " apex " << apex;
            }
        }
}

TEST(TetrahedronCut, LeavesAWholeOneAsItIs) {
    const auto pieces =
        piecesWithin({3, 1, 2, 0}, std::array{Side::Inside, Side::On, Side::Inside, Side::On});
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_TRUE(pieces[0].isWhole);
    EXPECT_EQ(pieces[0].corners[0], Edge(3, 3));
    EXPECT_TRUE(piecesWithin({0, 1, 2, 3}, std::array{Side::On, Side::On, Side::On, Side::Outside}).empty());
}

} // namespace
} // namespace esm
