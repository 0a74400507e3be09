#include "core/texture/atlas/charts/flattening.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Entries = std::vector<Eigen::Triplet<double>>;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// After these, steps change little.
constexpr int roundsOfTurning = 12;

/// A triangle laid into the plane by itself, and the cotangents of its angles.
struct FlatTriangle {
    std::array<Eigen::Vector2d, 3> corners;
    std::array<double, 3> cotangents;
};

std::vector<FlatTriangle> flatTriangles(const ChartMesh& disc) {
    std::vector<FlatTriangle> triangles;
    triangles.reserve(disc.corners.size());
    for (const Triangle& at : disc.corners) {
        const Eigen::Vector3d a = disc.vertices[at[1]] - disc.vertices[at[0]],
                              b = disc.vertices[at[2]] - disc.vertices[at[0]];
        const double doubled = a.cross(b).norm();
        FlatTriangle& flat = triangles.emplace_back();
        flat.corners = {Eigen::Vector2d(0, 0), Eigen::Vector2d(a.norm(), 0),
                        Eigen::Vector2d(a.dot(b) / a.norm(), doubled / a.norm())};
        for (std::size_t i = 0; i < 3; ++i)
            flat.cotangents[i] = (flat.corners[(i + 1) % 3] - flat.corners[i])
                                     .dot(flat.corners[(i + 2) % 3] - flat.corners[i]) /
                                 doubled;
    }
    return triangles;
}

/// Calls `visit(i, j, cotangent)` for each side of a triangle with its ends, 0 to 2, and the cotangent of the
/// angle at the corner that lies opposite.
template<typename Visit> void forEachSide(const FlatTriangle& flat, const Visit& visit) {
    for (std::size_t i = 0; i < 3; ++i)
        visit(i, (i + 1) % 3, flat.cotangents[(i + 2) % 3]);
}

/// Of the Laplacian by cotangents (Pinkall and Polthier 1993), without the half that all of it has.
/// @param offset of rows and columns
void addLaplacian(const ChartMesh& disc, const std::vector<FlatTriangle>& flats, int offset,
                  Entries& entries) {
    for (std::size_t t = 0; t < flats.size(); ++t)
        forEachSide(flats[t], [&](std::size_t i, std::size_t j, double cotangent) {
            const int a = offset + static_cast<int>(disc.corners[t][i]),
                      b = offset + static_cast<int>(disc.corners[t][j]);
            entries.emplace_back(a, a, cotangent);
            entries.emplace_back(b, b, cotangent);
            entries.emplace_back(a, b, -cotangent);
            entries.emplace_back(b, a, -cotangent);
        });
}

std::uint32_t farthestOnBorder(const ChartMesh& disc, std::uint32_t from) {
    const std::vector<std::uint32_t>& border = disc.borders[0];
    return *std::max_element(border.begin(), border.end(), [&](std::uint32_t a, std::uint32_t b) {
        return (disc.vertices[a] - disc.vertices[from]).squaredNorm() <
               (disc.vertices[b] - disc.vertices[from]).squaredNorm();
    });
}

/// Four times the map's Dirichlet energy less the area that it covers, as a quadratic form of all first
/// coordinates, then all second ones.
SparseMatrix conformalEnergy(const ChartMesh& disc, const std::vector<FlatTriangle>& flats) {
    const int count = static_cast<int>(disc.vertices.size());
    const std::vector<std::uint32_t>& border = disc.borders[0];
    Entries entries;
    entries.reserve(24 * flats.size() + 4 * border.size());
    addLaplacian(disc, flats, 0, entries);
    addLaplacian(disc, flats, count, entries);
    for (std::size_t i = 0; i < border.size(); ++i) {
        const int a = static_cast<int>(border[i]), b = static_cast<int>(border[(i + 1) % border.size()]);
        entries.emplace_back(a, count + b, -1.0);
        entries.emplace_back(count + b, a, -1.0);
        entries.emplace_back(b, count + a, 1.0);
        entries.emplace_back(count + a, b, 1.0);
    }
    const Eigen::Index rows = 2 * Eigen::Index{count};
    SparseMatrix energy(rows, rows);
    energy.setFromTriplets(entries.begin(), entries.end());
    return energy;
}

/// Least squares conformal maps (Lévy, Petitjean, Ray and Maillot 2002): angles are kept as well as they can
/// be. What they lose is the map's Dirichlet energy less the area that it covers, which is a sum over the
/// border alone (Desbrun, Meyer and Alliez 2002). It is smallest where a linear system holds, of both
/// coordinates together; two vertices far apart are pinned, without which all could shrink to a point.
std::optional<PlanePoints> conformal(const ChartMesh& disc, const std::vector<FlatTriangle>& flats) {
    const int count = static_cast<int>(disc.vertices.size());
    const std::uint32_t one = farthestOnBorder(disc, disc.borders[0][0]), other = farthestOnBorder(disc, one);
    const std::array<int, 4> pinned{static_cast<int>(one), static_cast<int>(other),
                                    static_cast<int>(one) + count, static_cast<int>(other) + count};
    const double apart = (disc.vertices[other] - disc.vertices[one]).norm();
    SparseMatrix energy = conformalEnergy(disc, flats);
    Eigen::VectorXd wanted = -apart * energy.col(pinned[1]);
    const auto isPinned = [&](Eigen::Index i) {
        return std::find(pinned.begin(), pinned.end(), i) != pinned.end();
    };
    energy.prune([&](Eigen::Index row, Eigen::Index column, double) {
        return row == column || (!isPinned(row) && !isPinned(column));
    });
    for (const int i : pinned) {
        energy.coeffRef(i, i) = 1;
        wanted[i] = i == pinned[1] ? apart : 0;
    }
    const Eigen::SimplicialLDLT<SparseMatrix> solver(energy);
    if (solver.info() != Eigen::Success) return std::nullopt;
    const Eigen::VectorXd solution = solver.solve(wanted);
    PlanePoints places(disc.vertices.size());
    for (int i = 0; i < count; ++i)
        places[static_cast<std::size_t>(i)] = {solution[i], solution[count + i]};
    return places;
}

/// The turn that brings a triangle nearest to where it lies.
Eigen::Matrix2d turnOf(const FlatTriangle& flat, const Triangle& at, const PlanePoints& places) {
    double cosine = 0, sine = 0;
    forEachSide(flat, [&](std::size_t i, std::size_t j, double cotangent) {
        const Eigen::Vector2d laid = places[at[j]] - places[at[i]], own = flat.corners[j] - flat.corners[i];
        cosine += cotangent * own.dot(laid);
        sine += cotangent * (own.x() * laid.y() - own.y() * laid.x());
    });
    const double length = std::hypot(cosine, sine);
    if (!(length > 0)) return Eigen::Matrix2d::Identity();
    Eigen::Matrix2d turn;
    turn << cosine, -sine, sine, cosine;
    return turn / length;
}

/// As rigid as possible (Liu, Zhang, Xu, Gotsman and Gortler 2008, A local/global approach to mesh
/// parameterization): each triangle is turned as it lies, then all vertices are moved to where turned
/// triangles differ least from what is laid. The matrix stays the same and is factorised once. It settles
/// what conformal maps leave open, that sizes differ over a chart, at the price of some angles.
bool stiffen(const ChartMesh& disc, const std::vector<FlatTriangle>& flats, PlanePoints& places) {
    const int count = static_cast<int>(disc.vertices.size());
    Entries entries;
    entries.reserve(12 * flats.size() + 1);
    addLaplacian(disc, flats, 0, entries);
    entries.emplace_back(0, 0, 1.0); // the first vertex stays at the origin: forces on all add up to none
    SparseMatrix laplacian(count, count);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<SparseMatrix> solver(laplacian);
    if (solver.info() != Eigen::Success) return false;
    for (int round = 0; round < roundsOfTurning; ++round) {
        Eigen::MatrixX2d wanted = Eigen::MatrixX2d::Zero(count, 2);
        for (std::size_t t = 0; t < flats.size(); ++t) {
            const Triangle& at = disc.corners[t];
            const Eigen::Matrix2d turn = turnOf(flats[t], at, places);
            forEachSide(flats[t], [&](std::size_t i, std::size_t j, double cotangent) {
                const Eigen::Vector2d side = cotangent * (turn * (flats[t].corners[j] - flats[t].corners[i]));
                wanted.row(static_cast<int>(at[j])) += side.transpose();
                wanted.row(static_cast<int>(at[i])) -= side.transpose();
            });
        }
        const Eigen::MatrixX2d solution = solver.solve(wanted);
        for (int i = 0; i < count; ++i)
            places[static_cast<std::size_t>(i)] = solution.row(i).transpose();
    }
    return true;
}

} // namespace

std::optional<PlanePoints> flattened(const ChartMesh& disc) {
    const std::vector<FlatTriangle> flats = flatTriangles(disc);
    std::optional<PlanePoints> places = conformal(disc, flats);
    if (!places || !stiffen(disc, flats, *places)) return std::nullopt;
    const bool isFinite = std::all_of(places->begin(), places->end(),
                                      [](const Eigen::Vector2d& place) { return place.allFinite(); });
    if (!isFinite) return std::nullopt;
    return places;
}

} // namespace esm
