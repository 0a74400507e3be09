#include "core/dynamics/contact/touched_surface.h"
#include "core/model/detail.h"
#include "core/project/simulated_network.h"
#include "tests/support/rounds.h"
#include "tests/support/test_surfaces.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

using namespace esm;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

using Points = std::vector<Vector3d>;
constexpr std::array<std::size_t, 5> lengths{1, 2, 3, 4, 9};

class RandomRows {
public:
    explicit RandomRows(unsigned seed) : m_random(seed) {}

    double number(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(m_random);
    }
    Vector3d point() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
    Matrix3d matrix() {
        Matrix3d matrix;
        matrix << point(), point(), point();
        return matrix;
    }

    /// Every vertex on so many nodes from anywhere.
    BindingRows rows(std::size_t vertices, std::size_t nodes, std::size_t length) {
        std::vector<std::uint32_t> all(nodes);
        std::iota(all.begin(), all.end(), 0U);
        BindingRows rows;
        for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
            std::shuffle(all.begin(), all.end(), m_random);
            std::vector<double> shares;
            for (std::size_t place = 0; place < length; ++place)
                shares.push_back(number(0.01, 1));
            const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
            for (double& share : shares)
                share /= sum;
            rows.add({std::span(all).first(length), shares});
        }
        return rows;
    }

private:
    std::mt19937 m_random;
};

double farthestApart(const Points& a, const Points& b) {
    EXPECT_EQ(a.size(), b.size());
    double most = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

/// A finer surface over nodes of which each is at a triangle.
struct Organ {
    TriangleMesh mesh = lumpySurface(12, 24);
    SpringNetwork network = networkOf(mesh, {Detail::Kind::Nodes, 40});

    Points drawn(const Points& positions) const { return drawnPositions(mesh, network, positions); }
};

Points mapped(const Points& points, const Matrix3d& linear, const Vector3d& shift) {
    Points result;
    for (const Vector3d& point : points)
        result.emplace_back(linear * point + shift);
    return result;
}

/// What the triangles at a node make of its surroundings: the deformation of each by solving for it.
std::vector<Matrix3d> solvedTurns(const std::vector<Triangle>& triangles, const Points& rest,
                                  const Points& now) {
    std::vector<Matrix3d> sums(rest.size(), Matrix3d::Zero());
    std::vector<double> areas(rest.size());
    const auto sides = [](const Triangle& t, const Points& at) {
        Matrix3d sides;
        sides << at[t[1]] - at[t[0]], at[t[2]] - at[t[0]], Vector3d::Zero();
        sides.col(2) = sides.col(0).cross(sides.col(1)).normalized();
        return sides;
    };
    for (const Triangle& triangle : triangles) {
        const Matrix3d before = sides(triangle, rest);
        const double area = before.col(0).cross(before.col(1)).norm();
        for (const std::uint32_t node : triangle) {
            sums[node] += area * sides(triangle, now) * before.inverse();
            areas[node] += area;
        }
    }
    for (std::size_t node = 0; node < sums.size(); ++node)
        sums[node] /= areas[node];
    return sums;
}

std::vector<std::string> problemsOf(const BindingRows& rows, std::size_t vertices) {
    return validate(Binding{{}, {}, rows}, vertices, 4);
}

TEST(BindingRows, OfAnyLengthFollowATurnAndAShiftExactly) {
    for (const std::size_t length : lengths) {
        SCOPED_TRACE(length);
        RandomRows random(seedOf(static_cast<int>(length)));
        Organ organ;
        const std::size_t nodes = organ.network.restPositions.size();
        organ.network.binding->vertices = random.rows(organ.mesh.vertices.size(), nodes, length);
        ASSERT_THAT(validate(*organ.network.binding, organ.mesh.vertices.size(), nodes), IsEmpty());
        const Matrix3d turn = Eigen::AngleAxisd(random.number(-3, 3), random.point().normalized()).matrix();
        const Vector3d shift = random.point();
        EXPECT_LT(farthestApart(organ.drawn(mapped(organ.network.restPositions, turn, shift)),
                                mapped(organ.mesh.vertices, turn, shift)),
                  1e-13);
        EXPECT_LT(farthestApart(organ.drawn(organ.network.restPositions), organ.mesh.vertices), 1e-15);
    }
}

TEST(BindingRows, OfAnyLengthFollowAnAffineDeformationAsTheFormulaSays) {
    for (const std::size_t length : lengths) {
        SCOPED_TRACE(length);
        RandomRows random(seedOf(static_cast<int>(length)));
        Organ organ;
        const Points& rest = organ.network.restPositions;
        const BindingRows rows = random.rows(organ.mesh.vertices.size(), rest.size(), length);
        organ.network.binding->vertices = rows;
        const Matrix3d linear = Matrix3d::Identity() + 0.3 * random.matrix();
        const Points now = mapped(rest, linear, random.point());
        const std::vector<Matrix3d> turns = solvedTurns(organ.network.binding->surface, rest, now);
        Points expected;
        for (std::size_t vertex = 0; vertex < organ.mesh.vertices.size(); ++vertex) {
            Vector3d place = Vector3d::Zero();
            for (std::size_t i = 0; i < length; ++i) {
                const std::uint32_t node = rows.nodes[length * vertex + i];
                place += rows.shares[length * vertex + i] *
                         (now[node] + turns[node] * (organ.mesh.vertices[vertex] - rest[node]));
            }
            expected.push_back(place);
        }
        EXPECT_LT(farthestApart(organ.drawn(now), expected), 1e-12);
    }
}

TEST(BindingRows, OverNodesThatTurnNothingFollowEveryAffineDeformationExactly) {
    for (const std::size_t length : lengths) {
        SCOPED_TRACE(length);
        RandomRows random(seedOf(static_cast<int>(length)));
        Points lattice, vertices;
        for (int node = 0; node < 12; ++node)
            lattice.push_back(random.point());
        const BindingRows rows = random.rows(50, lattice.size(), length);
        for (std::size_t vertex = 0; vertex < rows.size(); ++vertex) {
            vertices.emplace_back(Vector3d::Zero());
            for (std::size_t i = 0; i < length; ++i)
                vertices.back() += rows[vertex].shares[i] * lattice[rows[vertex].nodes[i]];
        }
        const Matrix3d linear = random.matrix();
        const Vector3d shift = random.point();
        EXPECT_LT(farthestApart(carried(vertices, {{}, {}, rows}, lattice, mapped(lattice, linear, shift)),
                                mapped(vertices, linear, shift)),
                  1e-14);
    }
}

TEST(BindingRows, MayBeOfDifferentLengths) {
    BindingRows rows;
    rows.add({std::array{2U}, std::array{1.0}});
    rows.add({std::array{0U, 1U, 2U, 3U}, std::array{0.125, 0.125, 0.25, 0.5}});
    rows.add({std::array{1U, 3U}, std::array{0.5, 0.5}});
    ASSERT_THAT(problemsOf(rows, 3), IsEmpty());
    EXPECT_THAT(mainNodes({{}, {}, rows}), ElementsAre(2, 3, 1));
    const Points rest(4, Vector3d::Zero()), now{{8, 0, 0}, {16, 0, 0}, {0, 4, 0}, {0, 0, 2}};
    EXPECT_THAT(carried({{0, 0, 0}, {1, 1, 1}, {0, 0, 5}}, {{}, {}, rows}, rest, now),
                ElementsAre(Vector3d(0, 4, 0), Vector3d(4, 2, 2), Vector3d(8, 0, 6)));
}

TEST(BindingRows, WithoutAnOrderOfTheirStartsAreAProblem) {
    const BindingRows sound{{0, 1, 5}, {0, 0, 1, 2, 3}, {1, 0.25, 0.25, 0.25, 0.25}};
    ASSERT_THAT(problemsOf(sound, 2), IsEmpty());
    for (const std::vector<std::uint32_t>& starts : std::vector<std::vector<std::uint32_t>>{
             {1, 2, 5}, {0, 5, 1}, {0, 0, 5}, {0, 5, 5}, {0, 1, 4}, {0, 1, 6}, {0, 4294967295U, 5}}) {
        BindingRows rows = sound;
        rows.starts = starts;
        EXPECT_THAT(problemsOf(rows, 2), ElementsAre(HasSubstr("starts of the rows"))) << starts[1];
    }
    for (const std::vector<std::uint32_t>& starts :
         std::vector<std::vector<std::uint32_t>>{{}, {0}, {0, 5}}) {
        BindingRows rows = sound;
        rows.starts = starts;
        EXPECT_THAT(problemsOf(rows, 2), testing::Contains(HasSubstr("of 2 drawn vertices are carried")));
    }
    BindingRows fewShares = sound;
    fewShares.shares.pop_back();
    EXPECT_THAT(problemsOf(fewShares, 2), ElementsAre(HasSubstr("number of nodes and shares")));
}

TEST(BindingRows, WithANodeThatIsNoneOrSharesNotOfOneAreAProblem) {
    const BindingRows sound{{0, 1, 5}, {0, 0, 1, 2, 3}, {1, 0.25, 0.25, 0.25, 0.25}};
    BindingRows rows = sound;
    rows.nodes[4] = 4;
    EXPECT_THAT(problemsOf(rows, 2), ElementsAre(HasSubstr("1 drawn point whose nodes do not exist")));
    for (const double share : {0.26, -0.25, std::nan("")}) {
        rows = sound;
        rows.shares[4] = share;
        EXPECT_THAT(problemsOf(rows, 2), ElementsAre(HasSubstr("drawn point 1"))) << share;
    }
}

TEST(BindingRows, OverALatticeAreNoRigidPieceAndHaveNoTrianglesToTouch) {
    RandomRows random(seedOf(0));
    const TriangleMesh mesh = lumpySurface(4, 6);
    SpringNetwork network;
    for (int node = 0; node < 8; ++node)
        network.restPositions.push_back(random.point());
    network.binding = Binding{{}, {}, random.rows(mesh.vertices.size(), 8, 8)};
    EXPECT_EQ(detailOf(network).kind, Detail::Kind::Nodes);
    EXPECT_TRUE(touchedSurface(mesh, network).empty());
    network.binding->lines = {{0, 1}};
    EXPECT_FALSE(touchedSurface(mesh, network).body) << "not all of it is at the line";
    network.binding = bindToLine(mesh.vertices.size(), {0, 1});
    EXPECT_EQ(detailOf(network).kind, Detail::Kind::Rigid);
    EXPECT_TRUE(touchedSurface(mesh, network).body);
}

} // namespace
