#include "core/texture/atlas/charts/segmentation.h"

#include "core/geometry/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace esm {

namespace {

/// What a step costs where the surface does not turn, against 1 where it has turned by 90°. More makes
/// pieces rounder, less lets them follow folds.
constexpr double costOfDistance = 0.25;

/// A piece is cut when the mean of its normals is shorter. A cap of a sphere is at 0.6 where its rim has
/// turned by 78°; laid flat by distance from its middle it would be stretched 1.4-fold there, and 1.17-fold
/// in the mean. Smaller pieces are left to be tried: rough surface turns however small they are.
constexpr double leastMeanNormal = 0.6;
constexpr std::size_t fewTriangles = 24;

/// A piece of more of the surface packs badly.
constexpr double largestShare = 0.1;

constexpr int mostRounds = 40;
constexpr int roundsOfHalving = 3, lastRounds = 3;

constexpr double unreached = std::numeric_limits<double>::infinity();

/// What surrounds a seed.
struct Piece {
    std::uint32_t seed = 0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< of length 1
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double area = 0, meanNormal = 1; ///< m²; length of the mean of the normals
    std::size_t triangles = 0;
    std::uint32_t farthest = noIndex; ///< of its triangles, not the seed, the one that cost most
};

/// Pieces grow from their seeds over the dual graph, always on by the triangle that costs least on its way
/// from its seed (Dijkstra), where a way costs its length times how far the surface turns from the piece's
/// mean normal. Then each seed goes to its piece's middle, and all grow anew, as in Lloyd's method (Sander,
/// Wood, Gortler, Snyder and Hoppe 2003, Multi-chart geometry images). Of equal costs the lower numbers come
/// first, so that a surface has the same pieces on every machine.
class Pieces {
public:
    explicit Pieces(const DualGraph& graph) : m_graph(graph) {}

    void addSeed(std::uint32_t triangle) {
        m_pieces.push_back({});
        m_pieces.back().seed = triangle;
        m_pieces.back().normal = m_graph.normals[triangle];
    }

    void grow() {
        m_owners.assign(m_graph.size(), noIndex);
        m_costs.assign(m_graph.size(), unreached);
        std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
        for (std::uint32_t i = 0; i < m_pieces.size(); ++i) {
            m_costs[m_pieces[i].seed] = 0;
            m_owners[m_pieces[i].seed] = i;
            steps.push({0, m_pieces[i].seed});
        }
        while (!steps.empty()) {
            const auto [cost, triangle] = steps.top();
            steps.pop();
            if (cost > m_costs[triangle]) continue;
            for (const std::uint32_t next : m_graph.across[triangle]) {
                if (next == noIndex) continue;
                const double onwards = cost + costOfStep(triangle, next);
                if (!(onwards < m_costs[next])) continue;
                m_costs[next] = onwards;
                m_owners[next] = m_owners[triangle];
                steps.push({onwards, next});
            }
        }
        measure();
    }

    void recentre() {
        std::vector<double> nearest(m_pieces.size(), unreached);
        for (std::uint32_t triangle = 0; triangle < m_owners.size(); ++triangle) {
            if (m_owners[triangle] == noIndex) continue;
            Piece& piece = m_pieces[m_owners[triangle]];
            const double distance = (m_graph.centres[triangle] - piece.centre).squaredNorm();
            if (!(distance < nearest[m_owners[triangle]])) continue;
            nearest[m_owners[triangle]] = distance;
            piece.seed = triangle;
        }
    }

    /// A border runs straighter when triangles with two sides on the other side of it go over. Seeds stay.
    void smoothBorders() {
        for (std::uint32_t triangle = 0; triangle < m_owners.size(); ++triangle) {
            const std::uint32_t own = m_owners[triangle];
            if (own == noIndex || m_pieces[own].seed == triangle) continue;
            const Triangle& across = m_graph.across[triangle];
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t one = across[i], other = across[(i + 1) % 3];
                if (one == noIndex || other == noIndex || m_owners[one] == own ||
                    m_owners[one] != m_owners[other])
                    continue;
                m_owners[triangle] = m_owners[one];
                break;
            }
        }
    }

    const std::vector<Piece>& all() const { return m_pieces; }

    std::vector<TriangleSet> sets() const {
        std::vector<TriangleSet> sets(m_pieces.size());
        for (std::uint32_t triangle = 0; triangle < m_owners.size(); ++triangle)
            if (m_owners[triangle] != noIndex) sets[m_owners[triangle]].push_back(triangle);
        return sets;
    }

private:
    using Step = std::pair<double, std::uint32_t>; ///< cost so far, triangle

    double costOfStep(std::uint32_t from, std::uint32_t to) const {
        const double turn = 1 - m_pieces[m_owners[from]].normal.dot(m_graph.normals[to]);
        return (costOfDistance + turn) * (m_graph.centres[to] - m_graph.centres[from]).norm();
    }

    void measure() {
        for (Piece& piece : m_pieces)
            piece = {piece.seed, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0, 1, 0, noIndex};
        for (std::uint32_t triangle = 0; triangle < m_owners.size(); ++triangle) {
            if (m_owners[triangle] == noIndex) continue;
            Piece& piece = m_pieces[m_owners[triangle]];
            const double area = m_graph.areas[triangle];
            piece.normal += area * m_graph.normals[triangle];
            piece.centre += area * m_graph.centres[triangle];
            piece.area += area;
            ++piece.triangles;
            if (triangle != piece.seed &&
                (piece.farthest == noIndex || m_costs[triangle] > m_costs[piece.farthest]))
                piece.farthest = triangle;
        }
        for (Piece& piece : m_pieces) {
            piece.meanNormal = piece.normal.norm() / piece.area;
            piece.centre /= piece.area;
            piece.normal = piece.normal.norm() > 0 ? piece.normal.normalized() : m_graph.normals[piece.seed];
        }
    }

    const DualGraph& m_graph;
    std::vector<Piece> m_pieces;
    std::vector<std::uint32_t> m_owners; ///< of each triangle its piece
    std::vector<double> m_costs;
};

/// The first triangle of each piece of the surface.
std::vector<std::uint32_t> firstOfPieces(const DualGraph& surface) {
    DisjointSets pieces(surface.size());
    for (std::uint32_t triangle = 0; triangle < surface.size(); ++triangle)
        for (const std::uint32_t next : surface.across[triangle])
            if (next != noIndex) pieces.join(triangle, next);
    std::vector<std::uint32_t> first;
    for (std::uint32_t triangle = 0; triangle < surface.size(); ++triangle)
        if (surface.areas[triangle] > 0 && pieces.lowest(triangle) == triangle) first.push_back(triangle);
    return first;
}

} // namespace

/// Every piece that turns too far gets a second seed where it is farthest from its first, until none does:
/// the number of pieces follows from the surface, and grows at most twofold at once.
std::vector<TriangleSet> segments(const DualGraph& surface, const Progress& progress) {
    ProgressParts rounds(progress);
    Pieces pieces(surface);
    double whole = 0;
    for (const double area : surface.areas)
        whole += area;
    for (const std::uint32_t triangle : firstOfPieces(surface))
        pieces.addSeed(triangle);
    pieces.grow();
    for (int round = 0; round < mostRounds; ++round) {
        reportProgress(rounds.nextOfRest(0.1), 1);
        std::vector<std::uint32_t> seeds;
        for (const Piece& piece : pieces.all())
            if (piece.triangles > fewTriangles &&
                (piece.meanNormal < leastMeanNormal || piece.area > largestShare * whole))
                seeds.push_back(piece.farthest);
        if (seeds.empty()) break;
        for (const std::uint32_t seed : seeds)
            pieces.addSeed(seed);
        pieces.grow();
        pieces.recentre();
        pieces.grow();
    }
    for (int round = 0; round < lastRounds; ++round) {
        reportProgress(rounds.nextOfRest(0.2), 1);
        pieces.recentre();
        pieces.grow();
    }
    pieces.smoothBorders();
    return pieces.sets();
}

std::array<TriangleSet, 2> halves(const DualGraph& graph) {
    Pieces whole(graph);
    whole.addSeed(0);
    whole.grow();
    const std::uint32_t oneEnd = whole.all()[0].farthest;
    Pieces fromEnd(graph);
    fromEnd.addSeed(oneEnd);
    fromEnd.grow();
    Pieces two(graph);
    two.addSeed(oneEnd);
    two.addSeed(fromEnd.all()[0].farthest);
    two.grow();
    for (int round = 0; round < roundsOfHalving; ++round) {
        two.recentre();
        two.grow();
    }
    std::vector<TriangleSet> sets = two.sets();
    return {std::move(sets[0]), std::move(sets[1])};
}

} // namespace esm
