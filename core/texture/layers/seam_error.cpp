#include "core/texture/atlas/patch_row.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_levels.h"
#include "core/texture/photo/bilinear.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace esm {

namespace {

/// An edge as one of its triangles has it, from the smaller vertex to the larger.
struct Side {
    const Image* page;
    Eigen::Vector2d start, end; ///< pixels
};

Eigen::Vector3d filtered(const Image& page, const Eigen::Vector2d& point) {
    const BilinearPlace place = bilinearPlace(page, point.x(), point.y());
    const auto colour = [&](int column, int row) {
        const std::uint8_t* pixel = page.at(column, row);
        return Eigen::Vector3d(pixel[0], pixel[1], pixel[2]);
    };
    const auto mixed = [&](int row) -> Eigen::Vector3d {
        return (1 - place.u) * colour(place.left, row) + place.u * colour(place.right, row);
    };
    return (1 - place.v) * mixed(place.top) + place.v * mixed(place.bottom);
}

/// Compared at every texel of the edge's length and at its ends: bilinear filtering is smooth between the
/// centres of texels, so steps of a texel miss little.
double difference(const Side& a, const Side& b) {
    const int steps = 1 + static_cast<int>(std::ceil((a.end - a.start).norm()));
    double largest = 0;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Eigen::Vector3d here = filtered(*a.page, a.start + t * (a.end - a.start));
        const Eigen::Vector3d there = filtered(*b.page, b.start + t * (b.end - b.start));
        largest = std::max(largest, (here - there).cwiseAbs().maxCoeff());
    }
    return largest;
}

/// The part of a patch that the renderer reads in a smaller page, in that page's texels: all that keeps
/// `inset` texels to each side. It is the patch made smaller about a middle.
///
/// The distance to a side is a corner's weight times the height over that side, so that each weight must be
/// inset / height at least. A height is area / side, where area is twice the triangle's. The three least
/// weights give the middle, and what is left of 1 without them is the scale. A patch too thin for any such
/// place, where they add up to more than 1, is read at the middle alone.
PatchCorners patchRead(const PatchCorners& patch, double inset, int halvings) {
    const Eigen::Vector2d along = patch[1] - patch[0], beside = patch[2] - patch[0];
    const double area = std::abs(along.x() * beside.y() - along.y() * beside.x());
    Eigen::Vector3d least;
    for (std::size_t i = 0; i < 3; ++i)
        least[static_cast<Eigen::Index>(i)] =
            inset * (patch[(i + 2) % 3] - patch[(i + 1) % 3]).norm() / std::max(area, 1e-12);
    const double sum = least.sum();
    least /= std::max(sum, 1.0);
    const Eigen::Vector2d middle = least[0] * patch[0] + least[1] * patch[1] + least[2] * patch[2];
    PatchCorners read;
    for (std::size_t i = 0; i < 3; ++i)
        read[i] = std::ldexp(1.0, -halvings) * (middle + std::max(0.0, 1 - sum) * patch[i]);
    return read;
}

} // namespace

double seamError(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<Image>& pages) {
    std::map<Edge, Side> firstSides;
    double largest = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::size_t from = corner, to = (corner + 1) % 3;
            if (mesh.triangles[i][from] > mesh.triangles[i][to]) std::swap(from, to);
            if (atlas.corners[i][from] == atlas.corners[i][to]) continue; // a point shows no edge
            const Side side{&pages[atlas.page[i]], atlas.corners[i][from], atlas.corners[i][to]};
            const auto [first, isNew] =
                firstSides.emplace(Edge{mesh.triangles[i][from], mesh.triangles[i][to]}, side);
            if (!isNew) largest = std::max(largest, difference(first->second, side));
        }
    }
    return largest;
}

double seamError(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<Image>& pages,
                 int halvings) {
    const double inset = levelInset(atlas.options, halvings);
    Atlas read = atlas;
    for (PatchCorners& patch : read.corners)
        patch = patchRead(patch, inset, halvings);
    return seamError(mesh, read, pages);
}

} // namespace esm
