#include "core/texture/layers/lit_triangles.h"

#include "core/support/parallel_steps.h"
#include "core/support/smooth_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace esm {

namespace {

/// Triangles that are followed to cover one; more would cost more than the rays.
constexpr std::size_t mostInSheet = 48;

constexpr double hidingTolerances = 20; ///< by which surface lies before what it hides wholly

using Box = Eigen::AlignedBox2d;

/// A triangle in the photo's plane.
struct View {
    Eigen::Matrix3d seen; ///< corners as columns: (x·w, y·w, w) as `photoMatrix` gives them
    std::array<Eigen::Vector2d, 3> corners; ///< pixels
    Box box;                                ///< of what shows near the photo; empty where nothing does
    double nearest, farthest;               ///< m from the photo's plane or the eye
    double area;                            ///< twice, pixels², above 0 or below by the side that is seen
    bool isWhole;                           ///< all of it lies before the eye
};

/// The photo and as much on all sides, beyond which nothing is compared.
Box around(PhotoSize photo) {
    return {Eigen::Vector2d(-photo.width, -photo.height),
            Eigen::Vector2d(2.0 * photo.width, 2.0 * photo.height)};
}

/// The part of a polygon, in the form of View::seen, where `boundary` · corner ≥ 0: Sutherland and Hodgman's
/// clipping (1974) against one plane. In homogeneous form, as a corner behind the eye has no place in the
/// photo that could be divided out.
std::vector<Eigen::Vector3d> cut(const std::vector<Eigen::Vector3d>& polygon,
                                 const Eigen::Vector3d& boundary) {
    std::vector<Eigen::Vector3d> part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double inA = boundary.dot(a), inB = boundary.dot(b);
        if (inA >= 0) part.push_back(a);
        if ((inA >= 0) != (inB >= 0)) part.emplace_back(a + inA / (inA - inB) * (b - a));
    }
    return part;
}

/// Of what shows within `region` of a triangle that reaches behind the eye.
Box boxOfPart(const Eigen::Matrix3d& seen, const Box& region) {
    std::vector<Eigen::Vector3d> part{seen.col(0), seen.col(1), seen.col(2)};
    for (int axis = 0; axis < 2; ++axis) {
        const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis), forward = Eigen::Vector3d::UnitZ();
        part = cut(part, along - region.min()[axis] * forward);
        part = cut(part, region.max()[axis] * forward - along);
    }
    Box box;
    for (const Eigen::Vector3d& corner : part) {
        if (!(corner.z() > 0)) return region; // it passes through the eye
        box.extend(Eigen::Vector2d(corner.head<2>() / corner.z()));
    }
    return box;
}

View viewOf(const TriangleMesh& mesh, const Triangle& triangle, const Eigen::Matrix4d& matrix,
            const Box& region) {
    Eigen::Matrix<double, 4, 3> seen;
    View view{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        seen.col(column) = matrix * mesh.vertices[triangle[i]].homogeneous();
        view.corners[i] = seen.col(column).head<2>() / seen(2, column);
        view.box.extend(view.corners[i]);
    }
    view.seen = seen.topRows<3>();
    view.nearest = seen.row(3).minCoeff();
    view.farthest = seen.row(3).maxCoeff();
    const Eigen::Vector2d u = view.corners[1] - view.corners[0], v = view.corners[2] - view.corners[0];
    view.area = u.x() * v.y() - u.y() * v.x();
    view.isWhole = seen.row(2).minCoeff() > 0 && view.box.min().allFinite() && view.box.max().allFinite();
    if (!view.isWhole) view.box = boxOfPart(view.seen, region);
    if (!(view.farthest > 0) || !view.box.intersects(region)) view.box.setEmpty();
    return view;
}

/// Whether a line along one of a's sides has all of a on one side and all of b on the other: the separating
/// axis of two convex polygons lies along a side of one of them. On the line counts as beyond, so that
/// neighbours are parted by the side they share.
bool isParted(const View& a, const View& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d &start = a.corners[i], side = a.corners[(i + 1) % 3] - start;
        const Eigen::Vector2d across(-side.y(), side.x());
        const double own = across.dot(a.corners[(i + 2) % 3] - start);
        bool isBeyond = true;
        for (const Eigen::Vector2d& corner : b.corners)
            isBeyond = isBeyond && across.dot(corner - start) * own <= 0;
        if (own != 0 && isBeyond) return true;
    }
    return false;
}

/// The same in space, by planes through the eye and a's sides, where b may reach behind it: there a plane
/// still has two sides, while places in the photo change theirs. Only a's sides are tried: that may miss a
/// line that parts them, and never finds one that does not.
bool isPartedFromPart(const View& a, const View& b) {
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Vector3d across = a.seen.col(i).cross(a.seen.col((i + 1) % 3));
        const double own = across.dot(a.seen.col((i + 2) % 3));
        if (own != 0 && (own * across.transpose() * b.seen).maxCoeff() <= 0) return true;
    }
    return false;
}

/// Of two whose boxes intersect. @param a before the eye as a whole
bool overlap(const View& a, const View& b) {
    return b.isWhole ? !isParted(a, b) && !isParted(b, a) : !isPartedFromPart(a, b);
}

/// Whether a line in the photo's plane may touch a view that it does not pass by: both ends beyond one of its
/// sides, or all its corners on one side of the line, part them. What is not parted so may touch.
bool mayTouch(const Eigen::Vector2d& start, const Eigen::Vector2d& end, const View& view) {
    const auto across = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& point) {
        return (b.x() - a.x()) * (point.y() - a.y()) - (b.y() - a.y()) * (point.x() - a.x());
    };
    bool allLeft = true, allRight = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d &a = view.corners[i], &b = view.corners[(i + 1) % 3];
        if (across(a, b, start) * view.area < 0 && across(a, b, end) * view.area < 0) return false;
        allLeft = allLeft && across(start, end, a) > 0;
        allRight = allRight && across(start, end, a) < 0;
    }
    return !allLeft && !allRight;
}

bool contains(const View& view, const Eigen::Vector2d& point) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d side = view.corners[(i + 1) % 3] - view.corners[i];
        const Eigen::Vector2d way = point - view.corners[i];
        if ((side.x() * way.y() - side.y() * way.x()) * view.area < 0) return false;
    }
    return view.area != 0;
}

/// What is asked first of a triangle that may lie in the way.
struct SeenPart {
    Box box; ///< as View has it
    double nearest;
    std::uint32_t triangle;
};

/// Triangles by the cells of a grid over their views. Two triangles for each cell on the mean; views of an
/// organ's triangles are of much the same size, for which a grid is quicker made and asked than a tree. The
/// triangles of a cell lie side by side in memory, with what rules most of them out.
class ViewGrid {
public:
    ViewGrid(const std::vector<View>& views, const Box& region) {
        for (const View& view : views)
            if (!view.box.isEmpty()) m_box.extend(view.box.intersection(region));
        m_cells = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(views.size()) / 2)), 1, 512);
        m_perCell = (m_box.sizes() / m_cells).cwiseMax(1e-300);
        m_ends.assign(static_cast<std::size_t>(m_cells) * static_cast<std::size_t>(m_cells) + 1, 0);
        for (const View& view : views)
            if (!view.box.isEmpty()) forEachCell(view.box, [&](std::size_t cell) { ++m_ends[cell + 1]; });
        std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
        m_parts.resize(m_ends.back());
        std::vector<std::size_t> next(m_ends.begin(), m_ends.end() - 1);
        for (std::uint32_t i = 0; i < views.size(); ++i)
            if (!views[i].box.isEmpty())
                forEachCell(views[i].box, [&](std::size_t cell) {
                    m_parts[next[cell]++] = {views[i].box, views[i].nearest, i};
                });
    }

    /// Whether `holds(part)` for any triangle that may overlap a box.
    template<typename Holds> bool anyOf(const Box& box, const Holds& holds) const {
        bool found = false;
        forEachCell(box, [&](std::size_t cell) {
            const auto part = [&](std::size_t place) {
                return m_parts.begin() + static_cast<std::ptrdiff_t>(place);
            };
            found = found || std::any_of(part(m_ends[cell]), part(m_ends[cell + 1]), holds);
        });
        return found;
    }

private:
    template<typename Visit> void forEachCell(const Box& box, const Visit& visit) const {
        const auto cell = [&](const Eigen::Vector2d& place, int axis) {
            return static_cast<int>(
                std::clamp((place[axis] - m_box.min()[axis]) / m_perCell[axis], 0.0, m_cells - 1.0));
        };
        for (int y = cell(box.min(), 1); y <= cell(box.max(), 1); ++y)
            for (int x = cell(box.min(), 0); x <= cell(box.max(), 0); ++x)
                visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(m_cells) +
                      static_cast<std::size_t>(x));
    }

    Box m_box;
    Eigen::Vector2d m_perCell;
    int m_cells = 1;
    std::vector<std::size_t> m_ends; ///< of each cell's parts, after a 0
    std::vector<SeenPart> m_parts;   ///< cell by cell
};

/// Without this, rays take half of the time of composing, and most of them only find what all of their
/// triangle has in common. So each triangle is asked first as a whole, in the photo's plane. Where Lit or
/// Hidden is not certain the answer is Unknown, and rays decide. Tried against rays, two of 1.2 million
/// triangles were taken for lit of which a ray found a point hidden (docs/performance.md).
class LightingFinder {
public:
    LightingFinder(const ShadowCaster& surface, const std::vector<View>& views, const Box& region)
        : m_surface(surface), m_views(views), m_grid(views, region) {}

    /// Lit: no other triangle whose view overlaps comes nearer than this one's farthest corner. Touching
    /// neighbours share a side and no area, so they do not count. Hidden: some sheet of triangles covers the
    /// view; it must cover its middle, so only those there are tried as its beginning.
    Lighting of(std::uint32_t triangle) const {
        const View& view = m_views[triangle];
        if (!view.isWhole || view.box.isEmpty()) return Lighting::Unknown;
        const auto mayHide = [&](const SeenPart& other) {
            return other.nearest < view.farthest && other.triangle != triangle &&
                   other.box.intersects(view.box) && overlap(view, m_views[other.triangle]);
        };
        if (!m_grid.anyOf(view.box, mayHide)) return Lighting::Lit;
        const Eigen::Vector2d middle = (view.corners[0] + view.corners[1] + view.corners[2]) / 3;
        const auto begins = [&](const SeenPart& other) {
            return other.nearest < view.nearest && isBefore(m_views[other.triangle], view) &&
                   contains(m_views[other.triangle], middle) && isCoveredFrom(other.triangle, view);
        };
        return m_grid.anyOf({middle, middle}, begins) ? Lighting::Hidden : Lighting::Unknown;
    }

private:
    /// So far that a ray would find all of the light hidden.
    bool isBefore(const View& other, const View& view) const {
        return other.isWhole && other.nearest > m_surface.tolerance &&
               other.farthest + hidingTolerances * m_surface.tolerance < view.nearest;
    }

    /// Whether triangles that hang together with `first`, which covers a point of the view, cover all of it.
    /// The sheet is followed over each side that may touch the view: as long as a triangle seen from the same
    /// side lies beyond it, the sheet goes on there and the view is still covered. An end of the surface lets
    /// light through; so may a fold, where the next triangle is seen from its other side and lies over the
    /// sheet instead of beyond it. Sides that do not touch the view need no neighbour.
    bool isCoveredFrom(std::uint32_t first, const View& view) const {
        std::vector<std::uint32_t> sheet{first};
        for (std::size_t i = 0; i < sheet.size(); ++i) {
            const View& known = m_views[sheet[i]];
            for (std::size_t side = 0; side < 3; ++side) {
                if (!mayTouch(known.corners[side], known.corners[(side + 1) % 3], view)) continue;
                const std::uint32_t next = m_surface.across[sheet[i]][side];
                if (next == noIndex || !isBefore(m_views[next], view) ||
                    !(m_views[next].area * known.area > 0))
                    return false;
                if (std::find(sheet.begin(), sheet.end(), next) != sheet.end()) continue;
                if (sheet.size() == mostInSheet) return false;
                sheet.push_back(next);
            }
        }
        return true;
    }

    const ShadowCaster& m_surface;
    const std::vector<View>& m_views;
    ViewGrid m_grid;
};

} // namespace

/// By a share of the model's size: rays know points only to single precision.
double hidingTolerance(const TriangleMesh& mesh) {
    return 1e-4 * boundingBox(mesh.vertices).diagonal().norm();
}

double hiddenShare(double behind, double tolerance) {
    return smoothStep(tolerance, hidingTolerances * tolerance, behind);
}

std::vector<Lighting> certainLighting(const ShadowCaster& surface, const Projector& projector,
                                      PhotoSize photo, const Progress& progress) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    const Eigen::Matrix4d matrix = photoMatrix(projector, photo);
    const std::vector<Triangle>& triangles = surface.mesh.triangles;
    std::vector<View> views(triangles.size());
    forEachInBlocks(views.size(), trianglesPerBlock, parts.next(0.2), [&](std::size_t i) {
        views[i] = viewOf(surface.mesh, triangles[i], matrix, around(photo));
    });
    reportProgress(parts.next(0), 1);
    const LightingFinder finder(surface, views, around(photo));
    reportProgress(parts.next(0.1), 1);
    std::vector<Lighting> lighting(triangles.size());
    forEachInBlocks(lighting.size(), trianglesPerBlock, parts.rest(),
                    [&](std::size_t i) { lighting[i] = finder.of(static_cast<std::uint32_t>(i)); });
    return lighting;
}

} // namespace esm
