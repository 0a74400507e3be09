#include "core/solid/graded_cells.h"

#include "tests/support/solid_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

namespace esm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

struct CellsOfBody {
    std::vector<ClosedBody> bodies;
    std::unique_ptr<BodyQuery> query;
    GradedCells cells;
};

CellsOfBody cellsOf(const TriangleMesh& mesh, double edge) {
    CellsOfBody result{closedBodiesOf(mesh), nullptr, {}};
    result.query = std::make_unique<BodyQuery>(result.bodies[0]);
    result.cells = gradedCells(edge, result.bodies[0], *result.query, {});
    return result;
}

CellsOfBody lumpyCells() {
    return cellsOf(lumpySurface(30, 60), boundingBox(lumpySurface(30, 60).vertices).sizes().minCoeff() / 20);
}

/// How many of the finest cubes are part of one that is so often doubled.
std::map<int, std::size_t> cubesByDoublings(const GradedCells& cells) {
    std::map<int, std::size_t> counts;
    for (const std::uint8_t doublings : cells.doublings)
        ++counts[doublings];
    return counts;
}

TEST(GradedCells, DoubleDeepWithin) {
    EXPECT_EQ(cubesByDoublings(lumpyCells().cells).size(), 3U);
    // Of a block of 40 cubes each way those from 2 to 38 are 2 wide, and of these those from 4 to 36 are 4
    // wide.
    auto counts = cubesByDoublings(cellsOf(test::block({0, 0, 0}, {40, 40, 40}), 1).cells);
    EXPECT_EQ(counts[2], 32U * 32 * 32);
    EXPECT_EQ(counts[1], 36U * 36 * 36 - counts[2]);
}

TEST(GradedCells, LieDeepWhereTheyAreWide) {
    const CellsOfBody body = lumpyCells();
    const GradedCells& cells = body.cells;
    for (std::size_t i = 0; i < cells.doublings.size(); ++i) {
        const int doublings = cells.doublings[i], width = 1 << doublings;
        const Vector3i cell = cells.grid.placeAt(i);
        if (doublings == 0 || cell != width * (cell / width)) continue;
        for (int corner = 0; corner < 9; ++corner) {
            const Vector3i at = corner == 8
                                    ? Vector3i::Ones()
                                    : Vector3i(2 * Vector3i(corner & 1, corner >> 1 & 1, corner >> 2));
            const Vector3d place = cells.placeOf(2 * cell + width * at);
            EXPECT_TRUE(body.query->contains(place));
            EXPECT_GE(body.query->nearest(place).distance, 0.65 * width * cells.edge * (1 - 1e-12));
        }
    }
}

TEST(GradedCells, AreOfTwiceTheirNeighboursWidthAtMost) {
    const GradedCells cells = lumpyCells().cells;
    for (std::size_t i = 0; i < cells.doublings.size(); ++i)
        for (int number = 0; number < 27; ++number) {
            const Vector3i beside =
                cells.grid.placeAt(i) + Vector3i(number % 3, number / 3 % 3, number / 9) - Vector3i::Ones();
            if (cells.grid.holds(beside)) {
                EXPECT_LE(std::abs(cells.doublingsAt(beside) - cells.doublings[i]), 1);
            }
        }
}

std::vector<GradedTetrahedron> allTetrahedra(const GradedCells& cells) {
    std::vector<GradedTetrahedron> all;
    for (std::size_t i = 0; i < cells.grid.size(); ++i)
        for (const GradedTetrahedron& tetrahedron : tetrahedraAt(cells, cells.grid.placeAt(i)))
            all.push_back(tetrahedron);
    return all;
}

TEST(GradedTetrahedra, FillTheCubesButForTheOutermostPyramids) {
    const GradedCells cells = lumpyCells().cells;
    double volume = 0;
    for (const GradedTetrahedron& tetrahedron : allTetrahedra(cells)) {
        EXPECT_GT(tetrahedron.volume(), 0);
        volume += tetrahedron.volume();
    }
    // A pyramid over each face of the grid's box is a sixth of a cube of the finest.
    const Vector3i& n = cells.grid.counts;
    const double outer = 2.0 * (n.x() * n.y() + n.y() * n.z() + n.z() * n.x()) / 6;
    EXPECT_NEAR(volume / 8, static_cast<double>(cells.grid.size()) - outer, 1e-6);
}

TEST(GradedTetrahedra, MeetFaceToFace) {
    const GradedCells cells = lumpyCells().cells;
    using Key = std::array<std::array<int, 3>, 3>;
    std::map<Key, int> sides; // how often a face is seen from its one side, less from the other
    std::map<Key, int> uses;
    for (const GradedTetrahedron& tetrahedron : allTetrahedra(cells))
        for (std::size_t apex = 0; apex < 4; ++apex) {
            Key key{};
            for (std::size_t i = 0, corner = 0; corner < 4; ++corner)
                if (corner != apex) {
                    const Vector3i& place = tetrahedron.corners[corner];
                    key[i++] = {place.x(), place.y(), place.z()};
                }
            std::sort(key.begin(), key.end());
            const auto at = [&](std::size_t i) { return Vector3d(key[i][0], key[i][1], key[i][2]); };
            const double side =
                (at(1) - at(0)).cross(at(2) - at(0)).dot(tetrahedron.corners[apex].cast<double>() - at(0));
            sides[key] += side > 0 ? 1 : -1;
            ++uses[key];
        }
    // Alone are faces at the hull alone, whose pyramids are left out: within a cube of the grid's sides.
    const auto isAtHull = [&](const Key& key) {
        return std::any_of(key.begin(), key.end(), [&](const auto& place) {
            const Vector3i corner(place[0], place[1], place[2]);
            return (corner.array() <= 1).any() || (corner.array() >= 2 * cells.grid.counts.array() - 1).any();
        });
    };
    for (const auto& [key, count] : uses) {
        ASSERT_LE(count, 2);
        EXPECT_TRUE(count == 2 ? sides[key] == 0 : isAtHull(key));
    }
}

} // namespace
} // namespace esm
